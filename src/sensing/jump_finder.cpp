// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "jump_finder.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/median.h"

namespace scan_to_path::sensing {
namespace {

constexpr double longest_slip = 0.0105;      // [s]; 10 ms, and stamps on a grid
constexpr double longest_leap = 0.135;       // [s], beside the path
constexpr double steady = 0.2;               // of the speed, by which steady motion may change
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
  for (std::size_t s = 2 * strides_.back(); static_cast<double>(s) * interval_ <= longest_leap; s *= 2) {
    long_strides_.push_back(s);
  }
}

MotionJumps JumpFinder::find(std::size_t begin, std::size_t end) const {
  const std::size_t longest = long_strides_.empty() ? strides_.back() : long_strides_.back();
  const MotionStretch stretch(readings_, begin, end, 3 * longest, limits_.gap);
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
    for (const std::size_t stride : long_strides_) {
      if (i % (stride / steps_per_stride + 1) == 0) lookBesideThePath(stretch, i, stride, found);
    }
  }
  const auto isNone = [](const HiddenJump& jump) { return jump.size == 0.0; };
  found.hidden.erase(std::remove_if(found.hidden.begin(), found.hidden.end(), isNone), found.hidden.end());
  return found;
}

/// By which a step may miss what is explained without being a jump.
double JumpFinder::slack(int coordinate, const ExplainedStep& explained) const {
  return stamp_error * explained.speed + limits_.resolution[static_cast<std::size_t>(coordinate)];
}

/// The common case, cheaply: the steps of all coordinates are those of the speed before.
bool JumpFinder::goesOn(const MotionStretch& stretch, std::size_t i, std::size_t stride) const {
  if (i < stretch.runBegin(i) + 2 * stride) return false;
  const auto &last = stretch.values(i), &middle = stretch.values(i - stride), &first = stretch.values(i - 2 * stride);
  const double ratio =
      (stretch.time(i) - stretch.time(i - stride)) / (stretch.time(i - stride) - stretch.time(i - 2 * stride));
  double most = 0.0;
  for (Eigen::Index k = 0; k < last.size(); ++k) {
    most = std::max(most, std::abs((last[k] - middle[k]) - (middle[k] - first[k]) * ratio));
  }
  return most <= limits_.jump;
}

/// The readings around the step from i - stride to i, by their stamps or as if they were taken evenly.
JumpFinder::Sides JumpFinder::sidesOf(const MotionStretch& stretch, std::size_t i, std::size_t stride, int coordinate,
                                      Clock clock) const {
  const auto time = [&](std::size_t k) {
    return clock == Clock::stamps ? stretch.time(k) : static_cast<double>(k) * interval_;
  };
  const double spacing = closest * static_cast<double>(stride) * interval_;
  Sides sides;
  for (std::size_t k = i - stride; sides.before.count < 3; k -= stride) {
    sides.before.addFarther(time(k), stretch.value(k, coordinate), spacing);
    if (k < stretch.runBegin(i) + stride) break;
  }
  for (std::size_t k = i; sides.after.count < 3 && k < stretch.runEnd(i); k += stride) {
    sides.after.addFarther(time(k), stretch.value(k, coordinate), spacing);
  }
  return sides;
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
  if (goesOn(stretch, i, stride)) return;
  for (int coordinate = 0; coordinate < stretch.coordinates(); ++coordinate) {
    const double step = stretch.value(i, coordinate) - stretch.value(i - stride, coordinate);
    const Sides sides = sidesOf(stretch, i, stride, coordinate, Clock::stamps);
    ExplainedStep explained = explainedStep(sides.before, sides.after);
    double hidden = explained.width();
    if (!isEven(stretch, i, stride)) {
      const Sides even_sides = sidesOf(stretch, i, stride, coordinate, Clock::evenly);
      const ExplainedStep evenly = explainedStep(even_sides.before, even_sides.after);
      hidden = std::max(hidden, evenly.width());
      if (evenly.excess(step) < explained.excess(step)) explained = evenly;
    }
    if (explained.excess(step) > limits_.jump + slack(coordinate, explained)) {
      if (!found.first) found.first = MotionJump{i, coordinate, step, explained.low, explained.high, 0.0};
      return;
    }
    const bool has_both_sides = i > stretch.runBegin(i) + stride && i + stride < stretch.runEnd(i);
    if (stride == strides_.back() && has_both_sides) note(hidden, coordinate, i, found);
  }
}

/// True when everything moves the same way on both sides of the step from i - stride to i, two strides far, whatever
/// part of them is looked at: rows that come and go as fast as that are not steady.
bool JumpFinder::isSteady(const MotionStretch& stretch, std::size_t i, std::size_t stride) const {
  const std::size_t part = std::max<std::size_t>(1, stride / steps_per_stride);
  const auto velocity = [&](std::size_t from, std::size_t to) {
    robot::JointVector v = robot::JointVector::Zero(stretch.coordinates());
    for (int k = 0; k < v.size(); ++k) v[k] = stretch.value(to, k) - stretch.value(from, k);
    return robot::JointVector(v / (stretch.time(to) - stretch.time(from)));
  };
  const robot::JointVector all = velocity(i - 3 * stride, i - stride);
  const auto isTheSame = [&](std::size_t from) {
    return (velocity(from, from + part) - all).norm() <= steady * all.norm();
  };
  for (std::size_t at = 0; at + part <= 2 * stride; at += part) {
    if (!isTheSame(i - 3 * stride + at) || !isTheSame(i + at)) return false;
  }
  return true;
}

/// Over tens of milliseconds a robot may well change its speed, but in a row it stays on its path: where it moves the
/// same way before and after, what motion does not explain must lie along that way.
void JumpFinder::lookBesideThePath(const MotionStretch& stretch, std::size_t i, std::size_t stride,
                                   MotionJumps& found) const {
  if (found.first || i < stretch.runBegin(i) + 3 * stride || i + 2 * stride >= stretch.runEnd(i)) return;
  const int size = stretch.coordinates();
  robot::JointVector before = robot::JointVector::Zero(size);
  robot::JointVector after = before, low = before, high = before, excess = before;
  for (int k = 0; k < size; ++k) {
    const Sides sides = sidesOf(stretch, i, stride, k, Clock::stamps);
    const ExplainedStep explained = explainedStep(sides.before, sides.after);
    const double step = stretch.value(i, k) - stretch.value(i - stride, k);
    before[k] = endMotion(sides.before).speed;
    after[k] = endMotion(sides.after).speed;
    low[k] = explained.low;
    high[k] = explained.high;
    excess[k] = std::max(step - high[k], 0.0) - std::max(low[k] - step, 0.0);
  }
  const double duration = stretch.time(i) - stretch.time(i - stride);
  const robot::JointVector way = before + after;
  if (0.5 * way.norm() * duration <= limits_.jump) return;
  const robot::JointVector beside = excess - way * (way.dot(excess) / way.squaredNorm());
  bool is_jump = false;
  int most = 0;  // what lies beside the path is shared out between all coordinates, but one of them jumped
  for (int k = 0; k < size; ++k) {
    if (std::abs(beside[k]) > limits_.jump + limits_.resolution[static_cast<std::size_t>(k)]) is_jump = true;
    if (std::abs(excess[k]) > std::abs(excess[most])) most = k;
  }
  if (!is_jump || !isSteady(stretch, i, stride)) return;
  found.first =
      MotionJump{i, most, stretch.value(i, most) - stretch.value(i - stride, most), low[most], high[most], 0.0};
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
    const SideReadings from = awayFromGap(i - 1, coordinate, gap / steps_per_stride, false);
    const SideReadings to = awayFromGap(i, coordinate, gap / steps_per_stride, true);
    const ExplainedStep explained = explainedStep(from, to);
    if (explained.excess(steps[coordinate]) > limits_.jump + slack(coordinate, explained)) {
      found.first = MotionJump{i, coordinate, steps[coordinate], explained.low, explained.high, gap};
      return;
    }
    if (from.count > 1 && to.count > 1) note(explained.width(), coordinate, i, found);
  }
}

}  // namespace scan_to_path::sensing
