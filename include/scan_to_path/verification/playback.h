// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/motion/motion_plan.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/toolpath/tool_path.h"
#include "scan_to_path/verification/path_deviation.h"

namespace scan_to_path::verification {

/// How far a trajectory, played back through forward kinematics, is off the path it was planned for.
struct PlaybackReport {
  std::size_t waypoints = 0;      ///< reached by the trajectory
  std::size_t missing = 0;        ///< of the path, not in the trajectory
  double position_rms = 0.0;      ///< of the tool centre point at waypoints [m]
  double position_largest = 0.0;  ///< [m]
  WaypointIndex position_largest_at;
  double angle_rms = 0.0;      ///< of the tool's attitude at waypoints [rad]
  double angle_largest = 0.0;  ///< [rad]
  WaypointIndex angle_largest_at;
  double chord_largest = 0.0;      ///< of the tool centre point off the straight worked moves [m]
  WaypointIndex chord_largest_at;  ///< the waypoint that the move leads to
  double air_chord_largest = 0.0;  ///< off the straight moves in the air [m]
  WaypointIndex air_chord_largest_at;
};

/// Plays the trajectory back with joint-linear moves between its points, `between` places looked at on each, through
/// KDL's forward kinematics, which shares no code with the solver of the inverse. A waypoint is the last trajectory
/// point of its segment and index; those before it are on the move to it. `T_tip_tcp` is the tool's mount,
/// `T_base_path` maps the path's frame into the robot's base.
/// Throws InputError for a trajectory point that names no waypoint, is out of order or has the wrong number of joints.
PlaybackReport playBack(const motion::Trajectory& trajectory, const robot::Robot& robot, const Frame& T_tip_tcp,
                        const toolpath::ToolPath& path, const Frame& T_base_path = Frame::Identity(), int between = 8);

}  // namespace scan_to_path::verification
