// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/motion/motion_plan.h"
#include "scan_to_path/pipeline/cell.h"
#include "scan_to_path/pipeline/input.h"
#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/pipeline/path_stage.h"
#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/program/program.h"
#include "scan_to_path/scan/no_returns.h"
#include "scan_to_path/scan/scan_cloud.h"
#include "scan_to_path/sensing/clock_offset.h"

/// The stages of a job, each a value in and a value out, as the command line and the nodelets call them.
namespace scan_to_path::pipeline {

/// A scan cloud in base_link (or in the frame of the file it came from), how it was looked at, and what is known of it.
struct ScanStage {
  std::shared_ptr<const scan::ScanCloud> cloud;  ///< never null; shared, so that handing it on copies no point
  Vector3 mean_beam = -Vector3::UnitZ();         ///< unit viewing direction in the cloud's frame
  scan::NoReturns no_returns;                    ///< of a sample log; a cloud does not tell
  StageReport report;
  std::vector<Accuracy> accuracy;
  std::vector<std::string> notes;
};

/// Places a sample log's samples and estimates the offset of the clocks.
ScanStage scanFromSamples(const scan::SampleLog& log, const Cell& cell, const ScanSection& options,
                          const ReportOptions& limits, int threads, const Progress& progress);

/// Takes a cloud from a PCD or PLY text; coordinates are multiplied by metresPerUnit. Sizes are checked for
/// plausibility unless `units_given`.
ScanStage scanFromCloud(std::string_view content, const std::string& name, Units units, bool units_given,
                        const ScanSection& options);

struct FitStage {
  scan::FittedScan scan;
  StageReport report;
  std::vector<Accuracy> accuracy;
  std::vector<std::string> notes;
};

FitStage fitStage(const ScanStage& scanned, const ScanSection& scan_options, const scan::FitOptions& fit_options,
                  const ReportOptions& limits, int threads, const Progress& progress);

struct MotionStage {
  motion::MotionPlan plan;
  std::vector<toolpath::WaypointVerdict> verdicts;  ///< the path's findings and the motion's verdicts, one a waypoint
  StageReport report;
  std::vector<Accuracy> accuracy;
  std::vector<std::string> notes;  ///< where a tolerance fails, and what may help
};

/// One verdict a waypoint of a path whose motion is not planned: its findings, and ok for all others, which have no
/// margin (NaN).
std::vector<toolpath::WaypointVerdict> pathVerdicts(const PathStage& path);

/// Plans the motion along the path that is driven and plays it back through kinematics that share no code with the
/// solver.
MotionStage motionStage(const PathStage& path, const Cell& cell, const JobOptions& options, const Progress& progress);

struct ProgramStage {
  std::vector<program::ProgramFile> files;
  StageReport report;              ///< waypoints of the path, and of the program read back
  std::vector<Accuracy> accuracy;  ///< of the program read back against the plan
  std::vector<std::string> notes;  ///< its discrepancies
};

/// `notices` and `provenance` are lines for the program's header.
ProgramStage programStage(const PathStage& path, const MotionStage& motion, const Cell& cell, const JobOptions& options,
                          const std::vector<std::string>& notices, const std::vector<std::string>& provenance);

/// pulses.csv and what reading it back found.
struct PulsesStage {
  std::string file;
  std::vector<Accuracy> accuracy;
  std::vector<std::string> notes;
};

PulsesStage pulsesStage(const MotionStage& motion, const Cell& cell);

}  // namespace scan_to_path::pipeline
