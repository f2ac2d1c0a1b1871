// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/robot/robot.h"
#include "scan_to_path/toolpath/tool_path.h"
#include "scan_to_path/toolpath/verdict.h"

namespace scan_to_path::motion {

using geometry::Frame;
using geometry::Vector3;
using robot::JointVector;
using toolpath::Verdict;
using toolpath::WaypointVerdict;

/// A joint configuration at a time; segment and index name the waypoint that it is, or that it leads to.
struct TrajectoryPoint {
  double time = 0.0;  ///< [s]
  int segment = 0;
  int index = 0;
  JointVector q;  ///< [rad]
};

struct Trajectory {
  std::vector<std::string> joint_names;
  std::vector<TrajectoryPoint> points;
};

struct MotionPlan {
  Trajectory trajectory;                  ///< in order; waypoints without a solution are missing
  std::vector<WaypointVerdict> verdicts;  ///< one per waypoint of the path, in order
  std::vector<double> feeds;              ///< driven on the move to each waypoint, in order: the path's or less [m/s]
  double max_chord_error = 0.0;           ///< joint-interpolated moves against straight lines between waypoints [m]
};

}  // namespace scan_to_path::motion
