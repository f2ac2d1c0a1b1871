// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/process/planner.h"
#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::pipeline {

/// What a finished cutting path is worth on the true surface, given in the path's frame: distance of the last pass's
/// contacts (earlier ones are off it on purpose), angle of its normals, and the material that the ball leaves between
/// rows, path.edge_margin inside the scanned outline and in path.region. The deepest cut is that of all
/// passes. The limits are those of options.report: a path that breaks one is another part's, or not good enough to be
/// driven. Nothing else of it flows back into the plan.
std::vector<Accuracy> compareWithReference(const process::PlannedPath& planned, const scan::FittedScan& scan,
                                           const JobOptions& options, const geometry::Surface& reference, int threads);

}  // namespace scan_to_path::pipeline
