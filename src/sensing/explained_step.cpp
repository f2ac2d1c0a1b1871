// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "explained_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_to_path::sensing {
namespace {

constexpr double readings_to_rest = 1.5;

void widen(ExplainedStep& explained, double step) {
  explained.low = std::min(explained.low, step);
  explained.high = std::max(explained.high, step);
}

/// `sense` is +1 for the side before the interval.
void widenBy(const EndMotion& motion, double duration, double sense, ExplainedStep& explained) {
  widen(explained, motion.mean_speed * duration);
  widen(explained, motion.speed * duration);
  widen(explained, (motion.speed + sense * 0.5 * motion.acceleration * duration) * duration);
  explained.speed = std::max(explained.speed, std::abs(motion.speed));
}

}  // namespace

EndMotion endMotion(const SideReadings& side) {
  EndMotion motion;
  if (side.count < 2) return motion;
  motion.mean_speed = (side.angle[0] - side.angle[1]) / (side.time[0] - side.time[1]);
  motion.speed = motion.mean_speed;
  if (side.count < 3) return motion;
  const double farther = (side.angle[1] - side.angle[2]) / (side.time[1] - side.time[2]);
  motion.acceleration = 2.0 * (motion.mean_speed - farther) / (side.time[0] - side.time[2]);
  motion.speed += 0.5 * motion.acceleration * (side.time[0] - side.time[1]);
  return motion;
}

ExplainedStep explainedStep(const SideReadings& before, const SideReadings& after) {
  const double duration = after.time[0] - before.time[0];
  const EndMotion end = endMotion(before), begin = endMotion(after);
  ExplainedStep explained;  // rest: what a joint may come from or go to where one side is missing
  if (before.count < 2 && after.count < 2) {
    explained.high = std::numeric_limits<double>::infinity();
    explained.low = -explained.high;
  }
  if (before.count > 1 && after.count > 1) explained.low = explained.high = end.speed * duration;
  if (before.count > 1) widenBy(end, duration, 1.0, explained);
  if (after.count > 1) widenBy(begin, duration, -1.0, explained);
  return explained;
}

bool isRestingNextTo(const SideReadings& side, double resolution) {
  if (side.count < 2) return false;
  const EndMotion motion = endMotion(side);
  const double outward = side.time[0] - side.time[1];  // positive before the interval, negative after it
  if (std::abs(motion.speed * outward) <= resolution) return true;
  const double next = motion.speed + readings_to_rest * outward * motion.acceleration;
  return motion.speed * next <= 0.0 || std::abs(next * outward) <= resolution;
}

}  // namespace scan_to_path::sensing
