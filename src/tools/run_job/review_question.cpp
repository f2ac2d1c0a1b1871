// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "tools/run_job/review_question.h"

#include <poll.h>
#include <ros/service.h>
#include <std_srvs/SetBool.h>
#include <unistd.h>

#include <cstdio>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::tools {

void ReviewQuestion::look() {
  if (is_answered_) return;
  if (!is_asked_) {
    is_asked_ = true;
    std::fprintf(stderr, "\nwrite what was planned? [y/n] ");
  }
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  while (!is_answered_ && ::poll(&input, 1, 0) > 0) {
    char letter = 0;
    const bool is_line = ::read(STDIN_FILENO, &letter, 1) == 1 && letter != '\n';
    if (is_line) {
      line_ += letter;
    } else {
      const auto word = trimmed(line_);
      tell(!word.empty() && (word.front() == 'y' || word.front() == 'Y'));
    }
  }
}

void ReviewQuestion::tell(bool is_wanted) {
  is_answered_ = true;
  std_srvs::SetBool accept;
  accept.request.data = static_cast<std::uint8_t>(is_wanted);
  if (!ros::service::call(service_, accept)) throw InputError(service_ + ": nobody answers");
  // Somebody else, as at the panel, was faster.
  if (accept.response.success == 0) std::fprintf(stderr, "%s\n", accept.response.message.c_str());
}

}  // namespace scan_to_path::tools
