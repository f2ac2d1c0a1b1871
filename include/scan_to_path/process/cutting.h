// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "scan_to_path/process/cutting_options.h"
#include "scan_to_path/process/planner.h"

namespace scan_to_path::process {

/// Plans the path of a ball end mill over a fitted scan: rows, passes through the stock, leads, links, and the
/// waypoints that would gouge as findings. Figures: rows, row_distance_min, _median and _max, waypoints,
/// cutting_length, path_length, time, scallop, gouges, uncovered_area and uncovered_share; no row distances and no
/// scallop where no two neighbouring rows are driven. Throws InputError for options out of range.
std::unique_ptr<Planner> makeCuttingPlanner(const CuttingOptions& options);

}  // namespace scan_to_path::process
