// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/job_output.h"

#include <algorithm>

#include "scan_to_path/common/output_directory.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/pipeline/summary.h"

namespace scan_to_path::pipeline {
namespace {

namespace fs = std::filesystem;

bool isResultFile(const std::string& name) {
  const bool is_module = name.rfind("program", 0) == 0 && fs::path(name).extension() == ".mod";
  return is_module || name == "program.pgf" || name == "path.csv" || name == "trajectory.csv" || name == "pulses.csv" ||
         name == "report.json" || name == "timing.json" || name == "scan.pcd";
}

}  // namespace

void JobOutput::setInput(const JobRequest& request, const JobOptions& options, const JobInput& input) {
  report_.process = request.process;
  report_.seed = request.seed;
  report_.input_file = input.name;
  report_.input_sha256 = input.sha256;
  report_.input_kind = enumName(input.kind);
  report_.input_frame = options.cell.base_link;
  report_.input_units = enumName(input.units);
}

void JobOutput::addStage(const StageReport& stage, const std::vector<Accuracy>& accuracy,
                         const std::vector<std::string>& notes) {
  auto& stages = report_.stages;
  const auto same =
      std::find_if(stages.begin(), stages.end(), [&](const auto& other) { return other.name == stage.name; });
  if (same == stages.end()) {
    stages.push_back(stage);
  } else {
    *same = stage;
  }
  setFigures(accuracy);
  report_.notes.insert(report_.notes.end(), notes.begin(), notes.end());
}

void JobOutput::setFigures(const std::vector<Accuracy>& figures) {
  auto& all = report_.accuracy;
  for (const auto& figure : figures) {
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const auto& other) { return other.name == figure.name; });
    if (same == all.end()) {
      all.push_back(figure);
    } else {
      *same = figure;
    }
  }
}

void JobOutput::dropFigures(const std::string& prefix) {
  auto& all = report_.accuracy;
  all.erase(
      std::remove_if(all.begin(), all.end(), [&](const auto& figure) { return figure.name.rfind(prefix, 0) == 0; }),
      all.end());
}

void JobOutput::setPath(toolpath::ToolPath path, std::vector<toolpath::WaypointVerdict> verdicts) {
  path_ = std::move(path);
  verdicts_ = std::move(verdicts);
  addFile("path.csv", toolpath::formatToolPath(path_));
}

void JobOutput::setLeftOut(std::vector<LeftOut> left_out, double share) {
  report_.left_out = std::move(left_out);
  report_.left_out_share = share;
}

bool JobOutput::hasFailedWaypoint() const {
  return std::any_of(verdicts_.begin(), verdicts_.end(),
                     [](const auto& verdict) { return verdict.verdict != toolpath::Verdict::ok; });
}

bool JobOutput::hasFailedTolerance() const {
  return std::any_of(report_.accuracy.begin(), report_.accuracy.end(),
                     [](const auto& figure) { return !figure.pass(); });
}

JobResult JobOutput::write(const JobRequest& request, const JobOptions& options, const Timing& timing,
                           const Progress& progress) {
  report_.place = placeOf(path_, options.cell.workpiece.frame());
  report_.exit = isBlocked() || !report_.left_out.empty() ? 1 : 0;
  JobOptions config = options;
  addFile("report.json", formatReport(report_, fieldReferences(config), path_, verdicts_));
  progress.update("write", 0.0);
  OutputDirectory directory(request.out, isResultFile);
  for (const auto& [name, content] : files_) directory.write(name, content);
  directory.write("timing.json", timing.format(request.threads, request.input, request.out));
  progress.checkCancelled();
  directory.commit();
  JobResult result;
  result.exit = report_.exit;
  result.summary = summarise(report_, path_, verdicts_);
  std::string line = "result in " + request.out.string() + ":";
  for (const auto& [name, content] : files_) line += " " + name;
  result.summary.push_back(line + " timing.json (" + fixed(timing.total(), 2) + " s)");
  return result;
}

}  // namespace scan_to_path::pipeline
