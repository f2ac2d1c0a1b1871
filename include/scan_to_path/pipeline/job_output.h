// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/job.h"
#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/pipeline/stage_runner.h"
#include "scan_to_path/pipeline/timing.h"

namespace scan_to_path::pipeline {

/// What the stages of a job found, as report and files. Grows stage by stage, whoever runs them, and is written once.
class JobOutput {
public:
  void setInput(const JobRequest& request, const JobOptions& options, const JobInput& input);

  /// Takes the place of a stage of the same name.
  void addStage(const StageReport& stage, const std::vector<Accuracy>& accuracy, const std::vector<std::string>& notes);

  /// Takes the place of figures of the same name, which are those of an earlier path.
  void setFigures(const std::vector<Accuracy>& figures);

  /// Forgets the figures whose names begin so.
  void dropFigures(const std::string& prefix);

  void addNote(const std::string& note) { report_.notes.push_back(note); }
  void addFile(const std::string& name, std::string content) { files_[name] = std::move(content); }

  /// The path that is driven, as path.csv, and the verdicts on its waypoints.
  void setPath(toolpath::ToolPath path, std::vector<toolpath::WaypointVerdict> verdicts);

  /// What a partial path leaves out of the planned one: the job is no success, whatever is written.
  void setLeftOut(std::vector<LeftOut> left_out, double share);

  bool hasFailedWaypoint() const;
  bool hasFailedTolerance() const;

  /// Whether a robot may not run what came out: a waypoint that would be driven, or a tolerance, fails.
  bool isBlocked() const { return hasFailedWaypoint() || hasFailedTolerance(); }

  /// Writes all files into request.out, whole or not at all. Throws InputError and Interrupted as runJob does.
  JobResult write(const JobRequest& request, const JobOptions& options, const Timing& timing, const Progress& progress);

private:
  Report report_;
  toolpath::ToolPath path_;
  std::vector<toolpath::WaypointVerdict> verdicts_;
  std::map<std::string, std::string> files_;
};

}  // namespace scan_to_path::pipeline
