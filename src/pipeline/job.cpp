// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/job.h"

#include <algorithm>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/common/version.h"
#include "scan_to_path/motion/trajectory.h"
#include "scan_to_path/pipeline/job_output.h"
#include "scan_to_path/pipeline/left_out.h"
#include "scan_to_path/pipeline/partial_stage.h"
#include "scan_to_path/pipeline/reference_stage.h"
#include "scan_to_path/pipeline/stage_runner.h"
#include "scan_to_path/pipeline/stages.h"

namespace scan_to_path::pipeline {
namespace {

/// A job under way: runs the stages one after the other and hands what they find to the output.
class Job {
public:
  Job(const JobRequest& request, const JobOptions& options, const Cell& cell, StageRunner& stages,
      const Progress& progress)
      : request_(request), options_(options), progress_(progress), cell_(cell), stages_(stages) {}

  JobResult run() {
    if (reaches(Stage::path)) planner_ = makePlanner(request_.process, options_);
    stages_.read(progress_);
    timing_.mark("read");
    scan();
    if (reaches(Stage::fit)) fit();
    if (reaches(Stage::path)) path();
    if (reaches(Stage::motion)) motion();
    if (request_.reference && reaches(Stage::path)) reference();
    if (reaches(Stage::motion)) trajectory();
    input();
    if (reaches(Stage::program)) program();
    if (!stages_.accepts(progress_)) throw Rejected();
    return output_.write(request_, options_, timing_, progress_);
  }

private:
  bool reaches(Stage stage) const { return request_.stop_after >= stage; }

  bool wants(Output output) const {
    return std::find(request_.outputs.begin(), request_.outputs.end(), output) != request_.outputs.end();
  }

  void take(const StageReport& report, const std::vector<Accuracy>& accuracy,
            const std::vector<std::string>& notes = {}) {
    output_.addStage(report, accuracy, notes);
    timing_.mark(report.name);
    progress_.update(report.name, 1.0);
  }

  void scan() {
    scan_ = stages_.scan(progress_);
    take(scan_.report, scan_.accuracy, scan_.notes);
  }

  void input() {
    input_ = stages_.input(scan_);
    output_.setInput(request_, options_, input_);
    if (input_.record) output_.addFile(input_.record->name, std::move(input_.record->content));
  }

  void fit() {
    fit_ = stages_.fit(scan_, progress_);
    take(fit_.report, fit_.accuracy, fit_.notes);
  }

  void path() {
    path_ = stages_.path(*planner_, fit_, progress_);
    driven_ = airRun(path_, cell_, options_.program);
    take(path_.report, path_.accuracy, path_.notes);
    output_.setPath(driven_.planned.path, pathVerdicts(driven_));
  }

  void motion() {
    motion_ = stages_.motion(driven_, progress_);
    output_.setPath(driven_.planned.path, motion_.verdicts);
    if (request_.allow_partial && !output_.hasFailedTolerance()) partial();
    take(motion_.report, motion_.accuracy, motion_.notes);
  }

  /// Goes on with what is left of the path when the waypoints that fail on the part are left out.
  void partial() {
    if (!output_.hasFailedWaypoint() && options_.program.dry_offset <= 0.0) return;
    PartialStage stage = partialStage(*planner_, path_, motion_, fit_.scan, cell_, options_, progress_);
    path_ = std::move(stage.path);
    driven_ = std::move(stage.driven);
    motion_ = std::move(stage.motion);
    output_.dropFigures("path_");
    output_.addStage(path_.report, path_.accuracy, {});
    output_.setPath(driven_.planned.path, motion_.verdicts);
    if (!stage.refusal.empty()) output_.addNote("--allow-partial: " + stage.refusal);
    if (stage.left_out.empty()) return;
    notices_ = partialNotices(stage.left_out, stage.left_out_share);
    output_.setLeftOut(std::move(stage.left_out), stage.left_out_share);
  }

  void reference() {
    output_.setFigures(compareWithReference(path_.planned, fit_.scan, options_, *request_.reference, request_.threads));
    timing_.mark("reference");
  }

  /// Last, so that nothing of it is written when the reference says that the path is not good enough.
  void trajectory() {
    if (output_.isBlocked()) {
      output_.addNote("no trajectory and no program written: see what failed");
      return;
    }
    output_.addFile("trajectory.csv", motion::formatTrajectory(motion_.plan.trajectory));
    if (options_.program.dry_offset > 0.0) {
      output_.addNote("air run: path, trajectory, pulses and program are lifted by " +
                      fixed(1e3 * options_.program.dry_offset, 1) + " mm, the process stays off");
    }
  }

  /// A robot moves on what is written here: nothing is while a waypoint, a tolerance or a read-back fails.
  void program() {
    if (output_.isBlocked()) return;
    ProgramStage program;
    if (wants(Output::abb)) {
      program = programStage(driven_, motion_, cell_, options_, notices_, provenance());
      take(program.report, program.accuracy, program.notes);
    }
    PulsesStage pulses;
    if (wants(Output::pulses)) {
      pulses = pulsesStage(motion_, cell_);
      output_.setFigures(pulses.accuracy);
      for (const auto& note : pulses.notes) output_.addNote(note);
    }
    if (output_.isBlocked()) return;
    for (auto& file : program.files) output_.addFile(file.name, std::move(file.content));
    if (wants(Output::abb)) noteWhatTheCellMustSay();
    if (wants(Output::pulses)) output_.addFile("pulses.csv", std::move(pulses.file));
  }

  std::vector<std::string> provenance() const {
    return {"input " + input_.name, "SHA-256 " + input_.sha256, std::string("scan_to_path ") + version};
  }

  /// Defaults that no part can tell: a program with them runs, but not well.
  void noteWhatTheCellMustSay() {
    const program::ProgramOptions& options = options_.program;
    const program::ProgramOptions defaults;
    if (options.tool_mass == defaults.tool_mass && options.tool_centre_of_gravity == defaults.tool_centre_of_gravity) {
      output_.addNote("tool load is the default " + fixed(options.tool_mass, 1) +
                      " kg: set program.tool_mass and program.tool_centre_of_gravity");
    }
    if (options.process_signal.empty()) {
      output_.addNote("ProcessOn in the program starts nothing: set program.process_signal, or fill it in");
    }
  }

  const JobRequest& request_;
  const JobOptions& options_;
  const Progress& progress_;
  const Cell& cell_;
  StageRunner& stages_;
  Timing timing_;
  JobInput input_;
  JobOutput output_;
  ScanStage scan_;
  FitStage fit_;
  std::unique_ptr<process::Planner> planner_;
  PathStage path_;    ///< on the part
  PathStage driven_;  ///< lifted in an air run
  MotionStage motion_;
  std::vector<std::string> notices_;
};

}  // namespace

void validateJob(const JobOptions& options) {
  validate(options, "");
  process::validateCutting(options.path, "path");
  program::validateProgramOptions(options.program);
}

JobResult runJob(const JobRequest& request, const JobOptions& options, const Progress& progress) {
  validateJob(options);
  const Cell cell = makeCell(options.cell, request.package_path);
  FileRunner stages(request, options, cell);
  return runJob(request, options, cell, stages, progress);
}

JobResult runJob(const JobRequest& request, const JobOptions& options, const Cell& cell, StageRunner& stages,
                 const Progress& progress) {
  return Job(request, options, cell, stages, progress).run();
}

}  // namespace scan_to_path::pipeline
