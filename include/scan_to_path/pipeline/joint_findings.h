// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/sensing/joint_jumps.h"

namespace scan_to_path::pipeline {

/// What to say of what the sensor was carried by: how far a slip could have moved it without being told from motion
/// (motion_jumps.h), where it moved unseen, and joint readings that a log repeats.
struct JointFindings {
  std::vector<Accuracy> accuracy;  ///< unseen_joint_jump [m], unseen_pauses
  std::vector<std::string> notes;
};

JointFindings jointFindings(const sensing::UnseenJumps& unseen, std::size_t times_repeated,
                            const ReportOptions& limits);

}  // namespace scan_to_path::pipeline
