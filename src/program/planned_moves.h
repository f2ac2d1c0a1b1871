// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/program/program.h"

namespace scan_to_path::program {

/// A waypoint ready to be written.
struct PlannedMove {
  int segment = 0;
  int index = 0;
  Frame T_workobject_tcp = Frame::Identity();
  JointVector q;            ///< [rad]
  double feed = 0.0;        ///< as the motion drives it [m/s]; of the first move start_speed
  bool process_on = false;  ///< what works runs while the tool moves here
  double zone = 0.0;        ///< [m]; 0: stop
};

/// Every waypoint of the path with its joint angles and zone, in order, checked. Throws InputError naming segment and
/// waypoint.
std::vector<PlannedMove> plannedMoves(const ProgramInput& input);

/// "segment row_3 (7) waypoint 12", for messages.
std::string waypointLabel(const toolpath::ToolPath& path, int segment, int index);

}  // namespace scan_to_path::program
