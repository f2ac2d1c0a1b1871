// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "jump_finder.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/median.h"

namespace scan_to_path::sensing {
namespace {

constexpr double longest_slip = 0.0105;      // [s]; 10 ms, and stamps on a grid
constexpr double stamp_error = 5e-4;         // [s]
constexpr double even = 0.05;                // of the median interval, by which even stamps differ
constexpr double closest = 0.5;              // of it: stamps closer than that make speeds of their errors
constexpr std::size_t steps_per_stride = 4;  // a slip then lies within one of the steps looked at, but for a quarter
constexpr std::size_t intervals_looked_at = 10000;

/// Over eight readings at a time, as they may come in bursts.
double medianInterval(const MotionReadings& readings) {
  const std::size_t burst = std::min<std::size_t>(8, readings.size() - 1);
  const std::size_t stride = std::max<std::size_t>(1, readings.size() / intervals_looked_at);
  std::vector<double> intervals;
  for (std::size_t i = burst; i < readings.size(); i += stride) {
    intervals.push_back((readings.timeOf(i) - readings.timeOf(i - burst)) / static_cast<double>(burst));
  }
  return median(std::move(intervals));
}

void note(double hidden, int coordinate, std::size_t i, MotionJumps& found) {
  HiddenJump& most = found.hidden[static_cast<std::size_t>(coordinate)];
  if (hidden > most.size) most = {i, coordinate, hidden};
}

}  // namespace

JumpFinder::JumpFinder(const MotionReadings& readings, const JumpLimits& limits)
    : readings_(readings), limits_(limits), interval_(medianInterval(readings)) {
  for (std::size_t s = 1; s == 1 || static_cast<double>(s) * interval_ <= longest_slip; s *= 2) strides_.push_back(s);
}

MotionJumps JumpFinder::find(std::size_t begin, std::size_t end) const {
  const MotionStretch stretch(readings_, begin, end, 3 * strides_.back(), limits_.gap);
  MotionJumps found;
  found.hidden.resize(static_cast<std::size_t>(stretch.coordinates()));
  for (std::size_t i = std::max<std::size_t>(begin, 1); i < end && !found.first; ++i) {
    if (stretch.runBegin(i) == i) {
      lookAcrossGap(i, found);
      continue;
    }
    for (const std::size_t stride : strides_) {
      if (i % std::max<std::size_t>(1, stride / steps_per_stride) != 0) continue;
      if (i < stretch.runBegin(i) + stride) break;
      lookAtStep(stretch, i, stride, found);
    }
  }
  const auto isNone = [](const HiddenJump& jump) { return jump.size == 0.0; };
  found.hidden.erase(std::remove_if(found.hidden.begin(), found.hidden.end(), isNone), found.hidden.end());
  return found;
}

double JumpFinder::slack(int coordinate, const ExplainedStep& explained) const {
  return stamp_error * explained.speed + limits_.resolution[static_cast<std::size_t>(coordinate)];
}

/// The common case, cheaply: the step is that of the speed before.
bool JumpFinder::goesOn(const MotionStretch& stretch, std::size_t i, std::size_t stride, int coordinate) const {
  if (i < stretch.runBegin(i) + 2 * stride) return false;
  const double now = stretch.time(i) - stretch.time(i - stride);
  const double before = stretch.time(i - stride) - stretch.time(i - 2 * stride);
  const double middle = stretch.value(i - stride, coordinate);
  const double change =
      (stretch.value(i, coordinate) - middle) - (middle - stretch.value(i - 2 * stride, coordinate)) * now / before;
  return std::abs(change) <= limits_.jump;
}

/// What the readings around the step from i - stride to i explain, by their stamps or as if they were taken evenly.
ExplainedStep JumpFinder::explainedAround(const MotionStretch& stretch, std::size_t i, std::size_t stride,
                                          int coordinate, Clock clock) const {
  const auto time = [&](std::size_t k) {
    return clock == Clock::stamps ? stretch.time(k) : static_cast<double>(k) * interval_;
  };
  const double spacing = closest * static_cast<double>(stride) * interval_;
  SideReadings before, after;
  for (std::size_t k = i - stride; before.count < 3; k -= stride) {
    before.addFarther(time(k), stretch.value(k, coordinate), spacing);
    if (k < stretch.runBegin(i) + stride) break;
  }
  for (std::size_t k = i; after.count < 3 && k < stretch.runEnd(i); k += stride) {
    after.addFarther(time(k), stretch.value(k, coordinate), spacing);
  }
  return explainedStep(before, after);
}

bool JumpFinder::isEven(const MotionStretch& stretch, std::size_t i, std::size_t stride) const {
  const std::size_t begin = std::max(stretch.runBegin(i), i < 3 * stride ? 0 : i - 3 * stride);
  const std::size_t end = std::min(stretch.runEnd(i), i + 2 * stride + 1);
  for (std::size_t k = begin + 1; k < end; ++k) {
    if (std::abs(stretch.time(k) - stretch.time(k - 1) - interval_) > even * interval_) return false;
  }
  return true;
}

void JumpFinder::lookAtStep(const MotionStretch& stretch, std::size_t i, std::size_t stride, MotionJumps& found) const {
  for (int coordinate = 0; coordinate < stretch.coordinates(); ++coordinate) {
    if (goesOn(stretch, i, stride, coordinate)) continue;
    const double step = stretch.value(i, coordinate) - stretch.value(i - stride, coordinate);
    ExplainedStep explained = explainedAround(stretch, i, stride, coordinate, Clock::stamps);
    double hidden = explained.high - explained.low;
    if (!isEven(stretch, i, stride)) {
      const ExplainedStep evenly = explainedAround(stretch, i, stride, coordinate, Clock::evenly);
      hidden = std::max(hidden, evenly.high - evenly.low);
      if (evenly.excess(step) < explained.excess(step)) explained = evenly;
    }
    if (explained.excess(step) > limits_.jump + slack(coordinate, explained)) {
      if (!found.first) found.first = MotionJump{i, coordinate, step, explained.low, explained.high, 0.0};
      return;
    }
    if (stride == 1 && i > stretch.runBegin(i) + 1 && i + 1 < stretch.runEnd(i)) note(hidden, coordinate, i, found);
  }
}

/// Up to three readings of a coordinate from `i` away from a gap, each at least `spacing` [s] after the last.
SideReadings JumpFinder::awayFromGap(std::size_t i, int coordinate, double spacing, bool forward) const {
  SideReadings side;
  side.addFarther(readings_.timeOf(i), readings_.valuesOf(i)[coordinate], spacing);
  const auto isGap = [&](std::size_t a, std::size_t b) {
    return std::abs(readings_.timeOf(a) - readings_.timeOf(b)) > limits_.gap;
  };
  for (std::size_t k = i; side.count < 3 && (forward ? k + 1 < readings_.size() : k > 0);) {
    const std::size_t next = forward ? k + 1 : k - 1;
    if (isGap(k, next)) break;
    k = next;
    side.addFarther(readings_.timeOf(k), readings_.valuesOf(k)[coordinate], spacing);
  }
  return side;
}

bool JumpFinder::restsAround(std::size_t i) const {
  for (int coordinate = 0; coordinate < readings_.valuesOf(i).size(); ++coordinate) {
    if (!isRestingNextTo(awayFromGap(i - 1, coordinate, 0.0, false),
                         limits_.resolution[static_cast<std::size_t>(coordinate)]))
      return false;
    if (!isRestingNextTo(awayFromGap(i, coordinate, 0.0, true),
                         limits_.resolution[static_cast<std::size_t>(coordinate)]))
      return false;
  }
  return true;
}

/// Over the gap that ends at reading i.
void JumpFinder::lookAcrossGap(std::size_t i, MotionJumps& found) const {
  const double gap = readings_.timeOf(i) - readings_.timeOf(i - 1);
  const robot::JointVector steps = readings_.valuesOf(i) - readings_.valuesOf(i - 1);
  const bool is_pause = restsAround(i);
  for (int coordinate = 0; coordinate < steps.size(); ++coordinate) {
    if (is_pause) {
      if (std::abs(steps[coordinate]) <= limits_.jump + limits_.resolution[static_cast<std::size_t>(coordinate)])
        continue;
      ++found.pauses;
      return;
    }
    const SideReadings from = awayFromGap(i - 1, coordinate, gap, false), to = awayFromGap(i, coordinate, gap, true);
    const ExplainedStep explained = explainedStep(from, to);
    if (explained.excess(steps[coordinate]) > limits_.jump + slack(coordinate, explained)) {
      found.first = MotionJump{i, coordinate, steps[coordinate], explained.low, explained.high, gap};
      return;
    }
    if (from.count > 1 && to.count > 1) note(explained.high - explained.low, coordinate, i, found);
  }
}

}  // namespace scan_to_path::sensing
