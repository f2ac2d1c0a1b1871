// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

namespace scan_to_path::tools {

/// Asks on the terminal whether what was planned is wanted, and tells the job server. Never waits.
class ReviewQuestion {
public:
  /// `service`: the job server's `accept`.
  explicit ReviewQuestion(std::string service) : service_(std::move(service)) {}

  /// To be called now and then while the job is in review: asks once, and hands the answer on when there is one: yes
  /// for a line that starts with y, no for any other and for the end of the input. Throws InputError when nobody takes
  /// it.
  void look();

private:
  void tell(bool is_wanted);

  std::string service_;
  std::string line_;
  bool is_asked_ = false;
  bool is_answered_ = false;
};

}  // namespace scan_to_path::tools
