// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/sensing/place_samples.h"

namespace scan_to_path::pipeline {

/// What to say of a log's joint readings: how far a slip could have moved the sensor without being told from motion
/// (joint_jumps.h), where the joints moved unseen, and readings that the log repeats.
struct JointFindings {
  std::vector<Accuracy> accuracy;  ///< unseen_joint_jump [m]
  std::vector<std::string> notes;
};

JointFindings jointFindings(const sensing::PlacedScan& scan, const robot::Robot& robot, const ReportOptions& limits);

}  // namespace scan_to_path::pipeline
