// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/job.h"

#include <algorithm>
#include <map>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/output_directory.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/common/version.h"
#include "scan_to_path/motion/trajectory.h"
#include "scan_to_path/pipeline/reference_stage.h"
#include "scan_to_path/pipeline/stages.h"
#include "scan_to_path/pipeline/summary.h"
#include "scan_to_path/pipeline/timing.h"

namespace scan_to_path::pipeline {
namespace {

namespace fs = std::filesystem;

bool isResultFile(const std::string& name) {
  const bool is_module = name.rfind("program", 0) == 0 && fs::path(name).extension() == ".mod";
  return is_module || name == "program.pgf" || name == "path.csv" || name == "trajectory.csv" || name == "pulses.csv" ||
         name == "report.json" || name == "timing.json";
}

/// A job under way: each stage's value, the report as it grows, and the files as they become ready.
class Job {
public:
  Job(const JobRequest& request, const JobOptions& options, const Progress& progress)
      : request_(request), options_(options), progress_(progress), cell_(makeCell(options.cell, request.package_path)) {
    checkOptions();
    report_.process = request.process;
    report_.seed = request.seed;
  }

  JobResult run() {
    scan();
    if (reaches(Stage::fit)) fit();
    if (reaches(Stage::path)) path();
    if (reaches(Stage::motion)) motion();
    if (reaches(Stage::program)) program();
    return write();
  }

private:
  bool reaches(Stage stage) const { return request_.stop_after >= stage; }

  void checkOptions() const {
    validate(options_, "");
    process::validateCutting(options_.path, "path");
    program::validateProgramOptions(options_.program);
  }

  void take(const StageReport& report, const std::vector<Accuracy>& accuracy) {
    report_.stages.push_back(report);
    report_.accuracy.insert(report_.accuracy.end(), accuracy.begin(), accuracy.end());
    timing_.mark(report.name);
    progress_.update(report.name, 1.0);
  }

  void scan() {
    progress_.update("read", 0.0);
    std::string content = readFile(request_.input);
    const std::string name = request_.input.filename().string();
    const InputKind kind = request_.input_kind ? *request_.input_kind : detectInput(content, name);
    const Units units = request_.units.value_or(Units::m);
    report_.input_file = name;
    report_.input_sha256 = sha256(content);
    report_.input_kind = enumName(kind);
    report_.input_frame = options_.cell.base_link;
    report_.input_units = enumName(units);
    if (kind == InputKind::samples) {
      const scan::SampleLog log = scan::parseSampleLog(content, name);
      content = std::string();
      timing_.mark("read");
      scan_ = scanFromSamples(log, cell_, options_.scan, options_.report, request_.threads, progress_);
    } else if (kind == InputKind::cloud) {
      scan_ = scanFromCloud(content, name, units, request_.units.has_value(), options_.scan);
    } else {
      throw InputError(name + ": is a " + enumName(kind) + "; " + request_.process +
                       " plans from a scan: a sample log or a cloud (scan a mesh with: scan_to_path emulate --workpiece " +
                       name + ")");
    }
    report_.notes = scan_.notes;
    take(scan_.report, scan_.accuracy);
  }

  void fit() {
    fit_ = fitStage(scan_, options_.scan, options_.fit, options_.report, request_.threads, progress_);
    take(fit_.report, fit_.accuracy);
    report_.notes.insert(report_.notes.end(), fit_.notes.begin(), fit_.notes.end());
  }

  void path() {
    path_ = pathStage(request_.process, fit_.scan, options_.cell.base_link, options_, progress_);
    verdicts_ = path_.planned.findings;
    take(path_.report, path_.accuracy);
    files_["path.csv"] = toolpath::formatToolPath(path_.planned.path);
    if (hasFailedTolerance("path_surface_residual_rms")) {
      report_.notes.push_back("the fitted surface is smooth and leaves the samples, as at folds: machine the scanned rows with "
                              "--set path.row_source=scan_lines, or scan fine relief at a smaller pitch");
    }
    if (hasFailedTolerance("path_between_rows_rms")) {
      report_.notes.push_back("the part is finer than the scan's rows: scan at a smaller pitch, or machine the scanned "
                              "rows alone with --set path.row_source=scan_lines");
    }
    if (!request_.reference) return;
    const auto figures =
        compareWithReference(path_.planned.path, fit_.scan, options_.path, *request_.reference, request_.threads);
    report_.accuracy.insert(report_.accuracy.end(), figures.begin(), figures.end());
    timing_.mark("reference");
  }

  void motion() {
    motion_ = motionStage(path_, cell_, options_, progress_);
    verdicts_ = motion_.verdicts;
    take(motion_.report, motion_.accuracy);
    if (hasFailed()) {
      report_.notes.push_back("no trajectory and no program written: see what failed");
    } else if (isAirRun()) {
      report_.notes.push_back("air run: the program is lifted by program.dry_offset; no trajectory or pulses, which are not");
    } else {
      files_["trajectory.csv"] = motion::formatTrajectory(motion_.plan.trajectory);
    }
  }

  /// Defaults that no part can tell: a program with them runs, but not well.
  void noteWhatTheCellMustSay() {
    const program::ProgramOptions& options = options_.program;
    const program::ProgramOptions defaults;
    if (options.tool_mass == defaults.tool_mass && options.tool_centre_of_gravity == defaults.tool_centre_of_gravity) {
      report_.notes.push_back("tool load is the default " + fixed(options.tool_mass, 1) +
                              " kg: set program.tool_mass and program.tool_centre_of_gravity");
    }
    if (options.process_signal.empty()) {
      report_.notes.push_back("ProcessOn in the program starts nothing: set program.process_signal, or fill it in");
    }
  }

  bool isAirRun() const { return options_.program.dry_offset > 0.0; }

  bool wants(Output output) const {
    return std::find(request_.outputs.begin(), request_.outputs.end(), output) != request_.outputs.end();
  }

  /// A robot moves on what is written here: nothing is while a waypoint, a tolerance or the read-back fails.
  void program() {
    if (hasFailed()) return;
    if (wants(Output::abb)) {
      const std::vector<std::string> provenance = {"input " + report_.input_file, "SHA-256 " + report_.input_sha256,
                                                   std::string("scan_to_path ") + version};
      const ProgramStage stage = programStage(path_, motion_, cell_, options_, provenance);
      take(stage.report, {{"read_back_discrepancies", static_cast<double>(stage.discrepancies.size()), "1", 0.0}});
      for (const auto& discrepancy : stage.discrepancies) report_.notes.push_back("read-back: " + discrepancy.text);
      if (hasFailed()) return;
      for (const auto& file : stage.files) files_[file.name] = file.content;
      noteWhatTheCellMustSay();
    }
    if (wants(Output::pulses) && !isAirRun()) {
      files_["pulses.csv"] = motion::formatPulses(motion_.plan.trajectory, cell_.encoders);
    }
  }

  bool hasFailedTolerance(const std::string& name) const {
    return std::any_of(report_.accuracy.begin(), report_.accuracy.end(),
                       [&](const auto& figure) { return figure.name == name && !figure.pass(); });
  }

  bool hasFailed() const {
    const bool waypoint = std::any_of(verdicts_.begin(), verdicts_.end(), [](const auto& verdict) {
      return verdict.verdict != toolpath::Verdict::ok;
    });
    const bool tolerance =
        std::any_of(report_.accuracy.begin(), report_.accuracy.end(), [](const auto& figure) { return !figure.pass(); });
    return waypoint || tolerance;
  }

  JobResult write() {
    report_.exit = hasFailed() ? 1 : 0;
    JobOptions options = options_;
    files_["report.json"] = formatReport(report_, fieldReferences(options), path_.planned.path, verdicts_);
    progress_.update("write", 0.0);
    OutputDirectory directory(request_.out, isResultFile);
    for (const auto& [name, content] : files_) directory.write(name, content);
    directory.write("timing.json", timing_.format(request_.threads, request_.input, request_.out));
    progress_.checkCancelled();
    directory.commit();
    JobResult result;
    result.exit = report_.exit;
    result.summary = summarise(report_, path_.planned.path, verdicts_);
    result.summary.push_back(resultLine());
    return result;
  }

  std::string resultLine() const {
    std::string line = "result in " + request_.out.string() + ":";
    for (const auto& [name, content] : files_) line += " " + name;
    return line + " timing.json (" + fixed(timing_.total(), 2) + " s)";
  }

  const JobRequest& request_;
  const JobOptions& options_;
  const Progress& progress_;
  Cell cell_;
  Timing timing_;
  Report report_;
  ScanStage scan_;
  FitStage fit_;
  PathStage path_;
  MotionStage motion_;
  std::vector<toolpath::WaypointVerdict> verdicts_;
  std::map<std::string, std::string> files_;
};

}  // namespace

JobResult runJob(const JobRequest& request, const JobOptions& options, const Progress& progress) {
  return Job(request, options, progress).run();
}

}  // namespace scan_to_path::pipeline
