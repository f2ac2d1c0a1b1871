// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "scan_to_path/common/progress.h"

namespace scan_to_path::tools {

/// One line on standard error that is redrawn while work goes on; silent when it is not a terminal.
class ProgressBar {
public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();

  /// A Progress that draws here and throws Interrupted after SIGINT or SIGTERM.
  Progress progress();

private:
  void draw(const std::string& stage, double fraction);

  bool active_;
  bool drawn_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point last_;
};

/// From now on SIGINT and SIGTERM cancel the running work instead of ending the process; a second one ends it.
void installCancelSignals();

}  // namespace scan_to_path::tools
