// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/pipeline/report.h"

namespace scan_to_path::pipeline {

/// What a user wants to know after a job, a line each: what came in, what was fitted, how good it is, how the path and
/// the motion came out, and which waypoints and tolerances fail. Lengths in mm or um, angles in degrees.
std::vector<std::string> summarise(const Report& report, const toolpath::ToolPath& path,
                                   const std::vector<toolpath::WaypointVerdict>& verdicts);

}  // namespace scan_to_path::pipeline
