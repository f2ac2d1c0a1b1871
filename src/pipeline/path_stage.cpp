// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/path_stage.h"

#include <algorithm>
#include <optional>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/process/cutting.h"
#include "scan_to_path/toolpath/air_run.h"

namespace scan_to_path::pipeline {
namespace {

/// Rows on the fitted surface are as far off the part as the surface is, on the scan's rows and between them.
void addSurfaceTolerances(const scan::FittedScan& scan, const ReportOptions& limits, std::vector<Accuracy>& accuracy) {
  accuracy.push_back(
      {"path_surface_residual_rms", scan.surface_rms, "m", limitUnlessZero(limits.max_surface_residual)});
  const std::optional<double> limit = limitUnlessZero(limits.max_between_rows);
  accuracy.push_back({"path_between_rows_rms", scan.between_rows_rms, "m", limit});
  accuracy.push_back({"between_rows_unknown", 1.0 - scan.between_rows_share, "1",
                      limit ? std::optional(limits.max_between_rows_unknown) : std::nullopt});
}

/// Rows of the scan, and those of a given pitch, lie where they were asked for, whatever they leave.
bool pitchFollowsScallop(const process::CuttingOptions& options) {
  return options.row_source == process::RowSource::surface && options.pitch == 0.0;
}

void noteSurface(PathStage& stage) {
  if (fails(stage.accuracy, "path_surface_residual_rms")) {
    stage.notes.push_back(
        "the fitted surface is smooth and leaves the samples, as at folds: machine the scanned rows with "
        "--set path.row_source=scan_lines, or scan fine relief at a smaller pitch");
  }
  if (fails(stage.accuracy, "path_between_rows_rms")) {
    stage.notes.push_back(
        "the part is finer than the scan's rows: scan at a smaller pitch, or machine the scanned rows "
        "alone with --set path.row_source=scan_lines");
  }
  if (fails(stage.accuracy, "between_rows_unknown")) {
    stage.notes.push_back(
        "where fewer than five rows pass nothing is known of the part between them: scan at least five rows over every "
        "part of it, machine the scanned rows alone with --set path.row_source=scan_lines, or take it as it is with "
        "--set report.max_between_rows=0");
  }
}

/// Rows whose distance was given, by the scan or by the user, may leave more than path.scallop_height.
void noteScallop(const process::CuttingOptions& options, PathStage& stage) {
  const auto& figures = stage.accuracy;
  const auto scallop =
      std::find_if(figures.begin(), figures.end(), [](const auto& f) { return f.name == "path_scallop"; });
  if (scallop == figures.end() || scallop->value <= options.scallop_height) return;
  stage.notes.push_back(
      "the rows leave a scallop of " + fixed(1e6 * scallop->value, 1) + " um, more than path.scallop_height, " +
      fixed(1e6 * options.scallop_height, 1) + " um: " +
      (options.row_source == process::RowSource::surface
           ? "lower path.pitch, or set it to 0"
           : "scan at a smaller pitch, or plan rows over the surface with --set path.row_source=surface"));
}

process::PlannerInput inputOf(const scan::FittedScan& scan, const std::string& frame, const JobOptions& options) {
  return {&scan, frame, options.cell.workpiece.frame()};
}

/// What stands on the part because the user wants it so.
void noteLeftStanding(const process::CuttingOptions& options, PathStage& stage) {
  if (!options.skip_rows.empty()) {
    stage.notes.push_back("rows " + options.skip_rows +
                          " are skipped (path.skip_rows): what they would take off stays, and path_scallop says "
                          "nothing of the strips beside them");
  }
  if (!options.region.empty()) {
    stage.notes.push_back("only what lies in path.region is machined; rows keep the numbers of the whole part");
  }
}

/// A part is scanned where its work object is, or beside it on a fixture; elsewhere one of the two poses is another's.
void noteFarWorkObject(const scan::FittedScan& scan, const JobOptions& options, PathStage& stage) {
  constexpr double usual = 2.0;  // of the part's size
  constexpr double least = 0.5;  // [m], of a fixture of a small part
  Eigen::AlignedBox3d part;
  for (const auto& line : scan.lines) {
    for (const Vector3& p : line.curve.control_points) part.extend(p);
  }
  if (part.isEmpty()) return;
  const double size = part.diagonal().norm();
  const double distance = part.exteriorDistance(Vector3(options.cell.workpiece.xyz));
  if (distance <= std::max(usual * size, least)) return;
  stage.notes.push_back("the part, " + fixed(size, 3) + " m across, lies " + fixed(distance, 3) +
                        " m from the work object's origin: where that is not its place, correct cell.workpiece, "
                        "cell.sensor or the cloud's frame");
}

PathStage described(process::PlannedPath planned, const scan::FittedScan& scan, const JobOptions& options) {
  PathStage stage;
  stage.planned = std::move(planned);
  stage.report = {"path", scan.samples_used, toolpath::waypointCount(stage.planned.path), {}};
  for (const auto& figure : stage.planned.figures) {
    stage.accuracy.push_back({"path_" + figure.name, figure.value, figure.unit});
    if (figure.name == "scallop" && pitchFollowsScallop(options.path)) {
      stage.accuracy.back().limit = options.path.scallop_height;
    }
  }
  if (options.path.row_source == process::RowSource::surface)
    addSurfaceTolerances(scan, options.report, stage.accuracy);
  noteSurface(stage);
  noteScallop(options.path, stage);
  noteLeftStanding(options.path, stage);
  noteFarWorkObject(scan, options, stage);
  return stage;
}

}  // namespace

std::unique_ptr<process::Planner> makePlanner(const std::string& process, const JobOptions& options) {
  if (process != "cutting") throw InputError("process '" + process + "' is not known; known: cutting");
  if (!options.fit.with_surface) {
    throw InputError(
        "fit.with_surface is false: cutting needs the surface for the distance of rows and to find gouges, with "
        "path.row_source=scan_lines too; set it to true, or stop after the fit");
  }
  return process::makeCuttingPlanner(options.path);
}

toolpath::Region regionOf(const JobOptions& options) {
  return toolpath::Region(options.path.region, options.cell.workpiece.frame().inverse());
}

PathStage pathStage(const process::Planner& planner, const scan::FittedScan& scan, const std::string& frame,
                    const JobOptions& options, const Progress& progress) {
  return described(planner.plan(inputOf(scan, frame, options), progress), scan, options);
}

PathStage pathWithout(const process::Planner& planner, const PathStage& whole,
                      const std::set<toolpath::WaypointIndex>& left_out, const scan::FittedScan& scan,
                      const std::string& frame, const JobOptions& options, const Progress& progress) {
  return described(planner.without(whole.planned, left_out, inputOf(scan, frame, options), progress), scan, options);
}

PathStage airRun(PathStage path, const Cell& cell, const program::ProgramOptions& options) {
  if (options.dry_offset <= 0.0) return path;
  const Vector3 direction = cell.T_base_workpiece.linear() * options.dry_direction.normalized();
  path.planned.path = toolpath::lifted(std::move(path.planned.path), options.dry_offset * direction);
  return path;
}

}  // namespace scan_to_path::pipeline
