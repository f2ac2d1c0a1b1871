// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "scan_to_path/sensing/motion_jumps.h"

namespace scan_to_path::sensing {

/// The coordinates of consecutive readings, worked out once, and the runs without a gap that they belong to. Readings
/// keep the numbers that MotionReadings gives them.
class MotionStretch {
public:
  /// Readings [begin, end) and up to `margin` on either side; a gap is longer than `max_gap` [s].
  MotionStretch(const MotionReadings& readings, std::size_t begin, std::size_t end, std::size_t margin, double max_gap)
      : first_(begin < margin ? 0 : begin - margin) {
    const std::size_t last = std::min(readings.size(), end + margin);
    for (std::size_t i = first_; i < last; ++i) {
      const bool goes_on = i > first_ && readings.timeOf(i) - readings.timeOf(i - 1) <= max_gap;
      time_.push_back(readings.timeOf(i));
      values_.push_back(readings.valuesOf(i));
      run_begin_.push_back(goes_on ? run_begin_.back() : i);
    }
    run_end_.assign(time_.size(), last);
    for (std::size_t i = last; i-- > first_;) {
      if (i + 1 < last) run_end_[i - first_] = runBegin(i + 1) == i + 1 ? i + 1 : runEnd(i + 1);
    }
  }

  double time(std::size_t i) const { return time_[i - first_]; }
  const robot::JointVector& values(std::size_t i) const { return values_[i - first_]; }
  double value(std::size_t i, int coordinate) const { return values_[i - first_][coordinate]; }
  int coordinates() const { return static_cast<int>(values_.front().size()); }

  /// The run without a gap that reading i is in, as far as the stretch goes: [runBegin, runEnd).
  std::size_t runBegin(std::size_t i) const { return run_begin_[i - first_]; }
  std::size_t runEnd(std::size_t i) const { return run_end_[i - first_]; }

private:
  std::size_t first_;
  std::vector<double> time_;  // [s]
  std::vector<robot::JointVector> values_;
  std::vector<std::size_t> run_begin_;
  std::vector<std::size_t> run_end_;
};

}  // namespace scan_to_path::sensing
