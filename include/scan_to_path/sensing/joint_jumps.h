// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/sensing/joint_readings.h"

namespace scan_to_path::sensing {

/// What the search for jumps asks of a log.
struct JointJumpLimits {
  double jump = 0.0;              ///< that motion does not explain [rad]
  double gap = 0.0;               ///< readings farther apart have a gap between them [s]
  std::vector<double> one_count;  ///< that a count turns each joint by [rad]
};

/// What a log without a visible jump still does not rule out.
struct UnseenJumps {
  double angle = 0.0;      ///< the largest jump that the motion around it would have explained [rad]
  double distance = 0.0;   ///< by which it moves what is measured [m]; 0: none above the limit for visible ones
  std::string what;        ///< jumps, in words
  double time = 0.0;       ///< of the reading after it [s]
  std::size_t pauses = 0;  ///< gaps between rests, with joints elsewhere after them: how they got there nobody saw
};

/// Throws InputError where a joint steps by more than `limits.jump` beyond what the readings before and after explain
/// (motion_jumps.h): a lost count, a slipped coupling, a new home position or a bad reading, after which everything is
/// measured somewhere else. Four counts of either joint are no step. Names joint, reading, time and limit. `spot_tip`
/// is what is measured, in the tip's frame [m]. Returns what jumps could hide in the changes of speed.
UnseenJumps checkJointJumps(const JointReadings& readings, const robot::Robot& robot, const geometry::Vector3& spot_tip,
                            const JointJumpLimits& limits, int threads = 1, const Progress& progress = {});

}  // namespace scan_to_path::sensing
