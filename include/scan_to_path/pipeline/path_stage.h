// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/pipeline/cell.h"
#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/process/planner.h"
#include "scan_to_path/program/options.h"
#include "scan_to_path/toolpath/region.h"

namespace scan_to_path::pipeline {

struct PathStage {
  process::PlannedPath planned;
  StageReport report;
  std::vector<Accuracy> accuracy;
  std::vector<std::string> notes;  ///< where a tolerance fails, and what rows cannot keep
};

/// The planner of `process`. Throws InputError for a process that is not there, naming those that are.
std::unique_ptr<process::Planner> makePlanner(const std::string& process, const JobOptions& options);

/// What of the part is machined: path.region over the work object frame, asked about points in base_link.
toolpath::Region regionOf(const JobOptions& options);

/// Plans with a planner. `frame` is the name of the scan's frame.
PathStage pathStage(const process::Planner& planner, const scan::FittedScan& scan, const std::string& frame,
                    const JobOptions& options, const Progress& progress);

/// The path `whole` without some contacts of its rows, as Planner::without has it; without segments when nothing is
/// left.
PathStage pathWithout(const process::Planner& planner, const PathStage& whole,
                      const std::set<toolpath::WaypointIndex>& left_out, const scan::FittedScan& scan,
                      const std::string& frame, const JobOptions& options, const Progress& progress);

/// The path that is driven: lifted by program.dry_offset, its findings kept, or as it is in a real run. Throws
/// InputError where the lift does not lead away from the surface.
PathStage airRun(PathStage path, const Cell& cell, const program::ProgramOptions& options);

}  // namespace scan_to_path::pipeline
