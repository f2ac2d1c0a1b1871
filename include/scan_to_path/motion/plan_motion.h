// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/common/options.h"
#include "scan_to_path/common/progress.h"
#include "scan_to_path/motion/motion_plan.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::motion {

struct MotionOptions {
  double chord_tolerance = 10e-6;
  double max_joint_step = 0.5;
  double joint_limit_margin = 0.0;
  double singular_limit = 0.02;
  double speed_fraction = 0.9;
  double least_feed_share = 0.25;
  double acceleration = 1.0;
  double shortest_move_time = 0.004;
  int candidate_waypoints = 500;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.chord_tolerance,
          Field{"chord_tolerance", "m", "how far a joint-interpolated move may leave the straight line", 1e-7, 0.01});
    visit(self.max_joint_step,
          Field{"max_joint_step", "rad", "larger step of a joint between neighbouring points is a jump", 1e-3, 3.1});
    visit(self.joint_limit_margin,
          Field{"joint_limit_margin", "rad", "distance that every joint keeps from its limits", 0.0, 1.0});
    visit(self.singular_limit,
          Field{"singular_limit", "",
                "least allowed singular value of the Jacobian, its linear rows divided by the arm's length", 0.0, 1.0});
    visit(self.speed_fraction, Field{"speed_fraction", "", "usable fraction of the joint speed limits", 0.01, 1.0});
    visit(self.least_feed_share,
          Field{"least_feed_share", "",
                "share of the feed down to which it is lowered where a joint would be too fast; 1: the waypoint fails",
                0.0, 1.0});
    visit(self.acceleration,
          Field{"acceleration", "m/s^2", "of the tool centre point along the path, in the timing", 0.01, 100.0});
    visit(self.shortest_move_time,
          Field{"shortest_move_time", "s",
                "moves between waypoints that last less are noted: a controller's cycle; 0: none", 0.0, 1.0});
    visit(self.candidate_waypoints,
          Field{"candidate_waypoints", "", "waypoints on which the first waypoint's configurations are compared", 2,
                1e6});
  }
};

/// Tip pose of a waypoint, T_base_tip = T_base_contact T_contact_tcp T_tip_tcp^-1 (spec cutting, eq. 13; lead, tilt,
/// offset and the half turn about x are in T_contact_tcp).
Frame tipPose(const Frame& T_base_contact, const Frame& T_contact_tcp, const Frame& T_tip_tcp);

/// Joint angles along a path, seed 000 eq. 14, and what stands in the way of driving it.
///
/// Every configuration of the first reachable waypoint is carried along a decimated path; the one with the fewest
/// failing waypoints, then the largest distance from the joint limits, then the lowest joint speeds is carried along
/// the whole path, each waypoint from the one before, whole turns nearest to it. The tool keeps the turn about its
/// axis that the path gives it. Moves between neighbouring waypoints get intermediate points until joint-interpolated
/// motion stays within chord_tolerance of the straight line. Times as in timing.h.
///
/// Limits of joints and of the robot's coupled axis are looked at alike. Where a joint would be too fast the feed is
/// lowered (driven_feed.h). Verdicts: unreachable, joint_limit, singular, jump and speed (moves with the process on
/// that would have to be slower still; others just take longer), the first of them in this order. A waypoint that is ok
/// has the margin that is smallest relative to its limit.
///
/// Poses are in the robot's base: throws InputError when path.frame is another one, when the path is empty, and for a
/// pose or a feed that is not finite or a feed that is not positive. Throws Interrupted.
MotionPlan planMotion(const toolpath::ToolPath& path, const robot::Robot& robot, const Frame& T_tip_tcp,
                      const MotionOptions& options, const Progress& progress = Progress());

}  // namespace scan_to_path::motion
