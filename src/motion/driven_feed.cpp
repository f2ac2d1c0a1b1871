// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/driven_feed.h"

#include <algorithm>
#include <cmath>

namespace scan_to_path::motion {

namespace {

constexpr double feed_step = 0.95;
constexpr double digits_per_unit = 1e6;  // [s/m]; 1e-6 m/s is the last digit that programs write

/// A feed that is whole digits but for rounding is that many.
double roundedDown(double feed) { return std::floor(feed * digits_per_unit + 1e-3) / digits_per_unit; }

}  // namespace

double drivenFeed(const robot::Robot& robot, const Arrival& arrival, const MotionOptions& options) {
  const JointVector usable = usableSpeeds(robot, options);
  const auto isTooFast = [&](double feed) { return ((arrival.rate * feed).array() > usable.array()).any(); };
  if (!arrival.process_on || !isTooFast(arrival.feed)) return arrival.feed;
  const double least = std::max(options.least_feed_share * arrival.feed, 1.0 / digits_per_unit);
  for (double feed = arrival.feed; feed > least;) {
    feed = std::max(feed_step * feed, least);
    const double written = roundedDown(feed);
    if (!isTooFast(written)) return written;
  }
  return arrival.feed;
}

}  // namespace scan_to_path::motion
