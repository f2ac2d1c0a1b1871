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
constexpr double counts_off = 4.0;           // both readings by one and a half, and rounding
constexpr double even = 0.05;                // of the median interval, by which even stamps differ
constexpr double closest = 0.5;              // of it: stamps closer than that make speeds of their errors
constexpr std::size_t steps_per_stride = 4;  // a slip then lies within one of the steps looked at, but for a quarter
constexpr std::size_t intervals_looked_at = 10000;

/// Over eight readings at a time, as they may come in bursts.
double medianInterval(const JointReadings& readings) {
  const std::size_t burst = std::min<std::size_t>(8, readings.size() - 1);
  const std::size_t stride = std::max<std::size_t>(1, readings.size() / intervals_looked_at);
  std::vector<double> intervals;
  for (std::size_t i = burst; i < readings.size(); i += stride) {
    intervals.push_back((readings.timeOf(i) - readings.timeOf(i - burst)) / static_cast<double>(burst));
  }
  return median(std::move(intervals));
}

void note(double hidden, int joint, std::size_t i, BlockFindings& found) {
  Hidden& most = found.hidden[static_cast<std::size_t>(joint)];
  if (hidden > most.angle) most = {hidden, i};
}

}  // namespace

JumpFinder::JumpFinder(const JointReadings& readings, const JointJumpLimits& limits)
    : readings_(readings), limits_(limits), interval_(medianInterval(readings)) {
  for (std::size_t s = 1; s == 1 || static_cast<double>(s) * interval_ <= longest_slip; s *= 2) strides_.push_back(s);
}

BlockFindings JumpFinder::find(std::size_t begin, std::size_t end) const {
  const JointStretch stretch(readings_, begin, end, 3 * strides_.back(), limits_.gap);
  BlockFindings found;
  for (std::size_t i = std::max<std::size_t>(begin, 1); i < end && !found.jump; ++i) {
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
  return found;
}

double JumpFinder::resolution(int joint) const {
  return counts_off * limits_.one_count[static_cast<std::size_t>(joint)];
}

double JumpFinder::slack(int joint, const ExplainedStep& explained) const {
  return stamp_error * explained.speed + resolution(joint);
}

/// The common case, cheaply: the step is that of the speed before.
bool JumpFinder::goesOn(const JointStretch& stretch, std::size_t i, std::size_t stride, int joint) const {
  if (i < stretch.runBegin(i) + 2 * stride) return false;
  const double now = stretch.time(i) - stretch.time(i - stride);
  const double before = stretch.time(i - stride) - stretch.time(i - 2 * stride);
  const double middle = stretch.angle(i - stride, joint);
  const double change =
      (stretch.angle(i, joint) - middle) - (middle - stretch.angle(i - 2 * stride, joint)) * now / before;
  return std::abs(change) <= limits_.jump;
}

/// What the readings around the step from i - stride to i explain, by their stamps or as if they were taken evenly.
ExplainedStep JumpFinder::explainedAround(const JointStretch& stretch, std::size_t i, std::size_t stride, int joint,
                                          Clock clock) const {
  const auto time = [&](std::size_t k) {
    return clock == Clock::stamps ? stretch.time(k) : static_cast<double>(k) * interval_;
  };
  const double spacing = closest * static_cast<double>(stride) * interval_;
  SideReadings before, after;
  for (std::size_t k = i - stride; before.count < 3; k -= stride) {
    before.addFarther(time(k), stretch.angle(k, joint), spacing);
    if (k < stretch.runBegin(i) + stride) break;
  }
  for (std::size_t k = i; after.count < 3 && k < stretch.runEnd(i); k += stride) {
    after.addFarther(time(k), stretch.angle(k, joint), spacing);
  }
  return explainedStep(before, after);
}

bool JumpFinder::isEven(const JointStretch& stretch, std::size_t i, std::size_t stride) const {
  const std::size_t begin = std::max(stretch.runBegin(i), i < 3 * stride ? 0 : i - 3 * stride);
  const std::size_t end = std::min(stretch.runEnd(i), i + 2 * stride + 1);
  for (std::size_t k = begin + 1; k < end; ++k) {
    if (std::abs(stretch.time(k) - stretch.time(k - 1) - interval_) > even * interval_) return false;
  }
  return true;
}

void JumpFinder::lookAtStep(const JointStretch& stretch, std::size_t i, std::size_t stride,
                            BlockFindings& found) const {
  for (int joint = 0; joint < stretch.joints(); ++joint) {
    if (goesOn(stretch, i, stride, joint)) continue;
    const double step = stretch.angle(i, joint) - stretch.angle(i - stride, joint);
    ExplainedStep explained = explainedAround(stretch, i, stride, joint, Clock::stamps);
    double hidden = explained.high - explained.low;
    if (!isEven(stretch, i, stride)) {
      const ExplainedStep evenly = explainedAround(stretch, i, stride, joint, Clock::evenly);
      hidden = std::max(hidden, evenly.high - evenly.low);
      if (evenly.excess(step) < explained.excess(step)) explained = evenly;
    }
    if (explained.excess(step) > limits_.jump + slack(joint, explained)) {
      if (!found.jump) found.jump = Jump{i, joint, step, explained};
      return;
    }
    if (stride == 1 && i > stretch.runBegin(i) + 1 && i + 1 < stretch.runEnd(i)) note(hidden, joint, i, found);
  }
}

/// Up to three readings of a joint from `i` away from a gap, each at least `spacing` [s] after the last.
SideReadings JumpFinder::awayFromGap(std::size_t i, int joint, double spacing, bool forward) const {
  SideReadings side;
  side.addFarther(readings_.timeOf(i), readings_.anglesOf(i)[joint], spacing);
  const auto isGap = [&](std::size_t a, std::size_t b) {
    return std::abs(readings_.timeOf(a) - readings_.timeOf(b)) > limits_.gap;
  };
  for (std::size_t k = i; side.count < 3 && (forward ? k + 1 < readings_.size() : k > 0);) {
    const std::size_t next = forward ? k + 1 : k - 1;
    if (isGap(k, next)) break;
    k = next;
    side.addFarther(readings_.timeOf(k), readings_.anglesOf(k)[joint], spacing);
  }
  return side;
}

bool JumpFinder::restsAround(std::size_t i) const {
  for (int joint = 0; joint < readings_.anglesOf(i).size(); ++joint) {
    if (!isRestingNextTo(awayFromGap(i - 1, joint, 0.0, false), resolution(joint))) return false;
    if (!isRestingNextTo(awayFromGap(i, joint, 0.0, true), resolution(joint))) return false;
  }
  return true;
}

/// Over the gap that ends at reading i.
void JumpFinder::lookAcrossGap(std::size_t i, BlockFindings& found) const {
  const double gap = readings_.timeOf(i) - readings_.timeOf(i - 1);
  const robot::JointVector steps = readings_.anglesOf(i) - readings_.anglesOf(i - 1);
  const bool is_pause = restsAround(i);
  for (int joint = 0; joint < steps.size(); ++joint) {
    if (is_pause) {
      if (std::abs(steps[joint]) <= limits_.jump + resolution(joint)) continue;
      ++found.pauses;
      return;
    }
    const SideReadings from = awayFromGap(i - 1, joint, gap, false), to = awayFromGap(i, joint, gap, true);
    const ExplainedStep explained = explainedStep(from, to);
    if (explained.excess(steps[joint]) > limits_.jump + slack(joint, explained)) {
      found.jump = Jump{i, joint, steps[joint], explained, gap};
      return;
    }
    if (from.count > 1 && to.count > 1) note(explained.high - explained.low, joint, i, found);
  }
}

}  // namespace scan_to_path::sensing
