// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace scan_to_path::pipeline {

/// How long the stages took: the one output that is different every time.
class Timing {
public:
  Timing() : start_(Clock::now()), last_(start_) {}

  /// Ends the stage under way and names it.
  void mark(const std::string& stage);

  double total() const;  ///< [s]

  /// The text of timing.json: seconds per stage, peak memory, threads, host, date, absolute paths.
  std::string format(int threads, const std::filesystem::path& input, const std::filesystem::path& out) const;

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  Clock::time_point last_;
  std::vector<std::pair<std::string, double>> stages_;
};

}  // namespace scan_to_path::pipeline
