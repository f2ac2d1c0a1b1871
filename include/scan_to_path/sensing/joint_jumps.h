// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/sensing/joint_readings.h"

namespace scan_to_path::sensing {

/// Throws InputError where a joint steps, from one reading to the next, by more than `limit` [rad] beyond what the
/// readings before and after explain: a lost count, a slipped coupling, a new home position or a bad reading, after
/// which everything is measured somewhere else. Explained is any speed between those of the five readings before and
/// after, stamps that are half a millisecond off, accelerations up to 10 rad/s^2 and four counts, which turn joint k by
/// 4 `one_count`[k]. Readings more than `max_gap` [s] apart are not compared. Names joint, reading, time and limit, the
/// first in time for any number of threads.
void checkJointJumps(const JointReadings& readings, const robot::Robot& robot, const std::vector<double>& one_count,
                     double limit, double max_gap, int threads = 1, const Progress& progress = {});

}  // namespace scan_to_path::sensing
