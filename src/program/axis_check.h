// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/program/rapid_reader.h"
#include "scan_to_path/robot/robot.h"

namespace scan_to_path::program {

using robot::JointVector;

/// What the other joints add to a coupled axis [rad].
double otherJoints(const robot::CoupledAxis& coupled, const JointVector& q);

/// What is wrong with the axes that a move read back from a program would stand at: quadrants and cfx that do not fit
/// the planned joint angles q of six axes [rad], axes beyond their ranges as the controller counts them. Shares no code
/// with axis_configuration.h, which wrote them.
std::vector<std::string> axisDiscrepancies(const robot::Robot& robot, const RapidMove& move, const JointVector& q);

}  // namespace scan_to_path::program
