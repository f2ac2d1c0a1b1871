// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/common/progress.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::motion {

using geometry::Frame;
using robot::JointVector;

/// What a waypoint was found to be, worst first when several apply.
enum class Verdict { ok, gouge, unreachable, joint_limit, singular, collision, speed, jump };

/// One waypoint's verdict with the evidence for it.
struct WaypointVerdict {
  int segment = 0;          ///< index into the path's segments
  int index = 0;            ///< index into the segment's waypoints
  Verdict verdict = Verdict::ok;
  double margin = 0.0;      ///< to the limit that decides, negative when broken
  std::string unit;         ///< of the margin, "rad", "rad/s", "m"
  std::string reason;       ///< e.g. "joint_4 needs 7.9 rad/s, limit 6.3"; empty when ok
  std::string remedy;       ///< what to change, e.g. "turn the part, lower the feed"; empty when ok
};

/// A joint configuration at a time; segment and index name the waypoint it belongs to.
struct TrajectoryPoint {
  double time = 0.0;  ///< [s]
  int segment = 0;
  int index = 0;
  JointVector q;      ///< [rad]
};

struct Trajectory {
  std::vector<std::string> joint_names;
  std::vector<TrajectoryPoint> points;
};

struct MotionPlan {
  Trajectory trajectory;                  ///< one point per waypoint that has a solution, in order
  std::vector<WaypointVerdict> verdicts;  ///< one per waypoint of the path, in order
  double max_chord_error = 0.0;           ///< joint-interpolated moves against straight lines between waypoints [m]
};

}  // namespace scan_to_path::motion

namespace scan_to_path {
template <>
struct EnumNames<motion::Verdict> {
  static constexpr std::array<const char*, 8> names = {"ok",       "gouge",     "unreachable", "joint_limit",
                                                       "singular", "collision", "speed",       "jump"};
};
}  // namespace scan_to_path
