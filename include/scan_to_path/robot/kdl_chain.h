// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kdl/chain.hpp>
#include <kdl/frames.hpp>

#include "scan_to_path/robot/robot.h"

namespace scan_to_path::robot {

/// The robot as KDL has it, one segment per joint as kdl_parser builds it: for solvers of that library, and for
/// kinematics that share no code with this package's own.
KDL::Chain kdlChain(const Robot& robot);

KDL::Frame toKdl(const Frame& T);
Frame fromKdl(const KDL::Frame& T);

}  // namespace scan_to_path::robot
