// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "motion/raster.h"
#include "scan_to_path/motion/plan_motion.h"
#include "support/irb2400.h"

namespace scan_to_path::motion::test {

inline std::map<Verdict, int> countVerdicts(const MotionPlan& plan) {
  std::map<Verdict, int> counts;
  for (const WaypointVerdict& verdict : plan.verdicts) ++counts[verdict.verdict];
  return counts;
}

/// The trajectory's point at every waypoint: the last one of those that name it.
inline std::map<std::pair<int, int>, TrajectoryPoint> waypointPoints(const Trajectory& trajectory) {
  std::map<std::pair<int, int>, TrajectoryPoint> points;
  for (const TrajectoryPoint& point : trajectory.points) points[{point.segment, point.index}] = point;
  return points;
}

inline std::size_t waypoints(const toolpath::ToolPath& path) {
  std::size_t count = 0;
  for (const auto& segment : path.segments) count += segment.waypoints.size();
  return count;
}

class PlanMotionTest : public testing::Test {
protected:
  MotionPlan plan(const toolpath::ToolPath& path) const { return planMotion(path, robot_, T_tip_tcp_, options_); }

  robot::Robot robot_ = scan_to_path::test::irb2400();
  Frame T_tip_tcp_ = spindleMount();
  MotionOptions options_;
};

}  // namespace scan_to_path::motion::test
