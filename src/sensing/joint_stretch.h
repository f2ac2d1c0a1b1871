// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "scan_to_path/sensing/joint_readings.h"

namespace scan_to_path::sensing {

/// The angles of consecutive readings, worked out once, and the runs without a gap that they belong to. Readings keep
/// the numbers that JointReadings gives them.
class JointStretch {
public:
  /// Readings [begin, end) and up to `margin` on either side; a gap is longer than `max_gap` [s].
  JointStretch(const JointReadings& readings, std::size_t begin, std::size_t end, std::size_t margin, double max_gap)
      : first_(begin < margin ? 0 : begin - margin) {
    const std::size_t last = std::min(readings.size(), end + margin);
    for (std::size_t i = first_; i < last; ++i) {
      const bool goes_on = i > first_ && readings.timeOf(i) - readings.timeOf(i - 1) <= max_gap;
      time_.push_back(readings.timeOf(i));
      angles_.push_back(readings.anglesOf(i));
      run_begin_.push_back(goes_on ? run_begin_.back() : i);
    }
    run_end_.assign(time_.size(), last);
    for (std::size_t i = last; i-- > first_;) {
      if (i + 1 < last) run_end_[i - first_] = runBegin(i + 1) == i + 1 ? i + 1 : runEnd(i + 1);
    }
  }

  double time(std::size_t i) const { return time_[i - first_]; }
  double angle(std::size_t i, int joint) const { return angles_[i - first_][joint]; }
  int joints() const { return static_cast<int>(angles_.front().size()); }

  /// The run without a gap that reading i is in, as far as the stretch goes: [runBegin, runEnd).
  std::size_t runBegin(std::size_t i) const { return run_begin_[i - first_]; }
  std::size_t runEnd(std::size_t i) const { return run_end_[i - first_]; }

private:
  std::size_t first_;
  std::vector<double> time_;  // [s]
  std::vector<robot::JointVector> angles_;
  std::vector<std::size_t> run_begin_;
  std::vector<std::size_t> run_end_;
};

}  // namespace scan_to_path::sensing
