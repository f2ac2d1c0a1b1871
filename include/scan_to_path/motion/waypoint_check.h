// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/motion/plan_motion.h"
#include "scan_to_path/robot/inverse_kinematics.h"

namespace scan_to_path::motion {

/// The move that leads to a waypoint: the largest values over its pieces, per joint (or the controller's axis in its
/// place).
struct Arrival {
  JointVector nearest_limit;  ///< the point between that comes nearest to a joint limit; empty without any
  JointVector step;           ///< between neighbouring points [rad]
  JointVector rate;           ///< per way of the tool centre point [rad/m]
  double feed = 0.0;          ///< that it is driven at [m/s]
  bool process_on = false;    ///< whether that feed matters
};

/// Smallest singular value of the Jacobian with its linear rows divided by `length` [m]: 0 in a singular pose.
double smallestSingularValue(const robot::Robot& robot, const JointVector& q, double length);

/// The length that makes an arm's linear and angular speeds comparable: the sum of its links' lengths after joint 1
/// [m].
double characteristicLength(const robot::Robot& robot);

/// How fast each joint may turn, and the controller's axis in its place: the usable fraction of its limit [rad/s].
JointVector usableSpeeds(const robot::Robot& robot, const MotionOptions& options);

/// The verdict on joint angles q and, unless null, on the move that leads there, its intermediate points included.
/// Segment and index are left 0.
WaypointVerdict checkWaypoint(const robot::Robot& robot, const JointVector& q, const Arrival* arrival,
                              const MotionOptions& options);

/// The verdict on a pose without joint angles.
WaypointVerdict unreachableVerdict(const Frame& T_base_tip, const robot::Miss& miss);

}  // namespace scan_to_path::motion
