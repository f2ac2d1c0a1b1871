// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/process/cutting_options.h"
#include "scan_to_path/process/planner.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/region.h"

namespace scan_to_path::pipeline {

/// What a finished cutting path is worth on the true surface, given in the path's frame: distance of the last pass's
/// contacts (earlier ones are off it on purpose), angle of its normals, and the material that the ball leaves between
/// rows, path.edge_margin inside the scanned outline and in the region [path's frame]. The deepest cut is that of all
/// passes. Nothing of it flows back into the plan.
std::vector<Accuracy> compareWithReference(const process::PlannedPath& planned, const scan::FittedScan& scan,
                                           const process::CuttingOptions& options, const geometry::Surface& reference,
                                           const toolpath::Region& region, int threads);

}  // namespace scan_to_path::pipeline
