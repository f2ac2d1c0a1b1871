// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/plan_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan_motion_fixture.h"

namespace scan_to_path::motion {
namespace {

using scan_to_path::test::denavitHartenberg;
using test::PlanMotionTest;
using test::Raster;
using test::rasterPath;
using test::waypointPoints;

/// Largest distance [m] of the joint-interpolated tool from the straight lines between neighbouring waypoints.
double denseChordError(const toolpath::ToolPath& path, const Trajectory& trajectory, const Frame& T_tip_tcp) {
  const auto tcp = [&](const JointVector& q) {
    return Vector3((denavitHartenberg(q.data()) * T_tip_tcp).translation());
  };
  const auto waypoint = [&](const TrajectoryPoint& p) {
    return Vector3(
        (path.segments[static_cast<std::size_t>(p.segment)].waypoints[static_cast<std::size_t>(p.index)].pose *
         path.T_contact_tcp)
            .translation());
  };
  double error = 0.0;
  Vector3 from = waypoint(trajectory.points.front());
  for (std::size_t i = 1; i < trajectory.points.size(); ++i) {
    const TrajectoryPoint &before = trajectory.points[i - 1], &point = trajectory.points[i];
    if (before.segment != point.segment || before.index != point.index) from = waypoint(before);
    const Vector3 line = waypoint(point) - from;
    for (int k = 0; k <= 20; ++k) {
      const Vector3 off = tcp(before.q + 0.05 * k * (point.q - before.q)) - from;
      const double u = line.norm() > 0 ? std::clamp(off.dot(line) / line.squaredNorm(), 0.0, 1.0) : 0.0;
      error = std::max(error, (off - u * line).norm());
    }
  }
  return error;
}

TEST_F(PlanMotionTest, StaysWithinTheChordTolerance) {
  Raster raster;
  raster.points = 7;  // 40 mm apart
  const auto path = rasterPath(raster);
  std::size_t points_before = 0;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    options_.chord_tolerance = tolerance;
    const MotionPlan result = plan(path);
    EXPECT_LE(result.max_chord_error, tolerance);
    EXPECT_LE(denseChordError(path, result.trajectory, T_tip_tcp_), tolerance);
    EXPECT_GT(result.trajectory.points.size(), points_before);
    points_before = result.trajectory.points.size();
  }
}

TEST_F(PlanMotionTest, ChordCheckSeesMissingPoints) {
  Raster raster;
  raster.points = 7;
  const auto path = rasterPath(raster);
  MotionPlan result = plan(path);
  Trajectory thinned;
  for (const auto& entry : waypointPoints(result.trajectory)) thinned.points.push_back(entry.second);
  EXPECT_GT(denseChordError(path, thinned, T_tip_tcp_), options_.chord_tolerance);
}

}  // namespace
}  // namespace scan_to_path::motion
