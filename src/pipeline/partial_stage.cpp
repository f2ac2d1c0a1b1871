// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/partial_stage.h"

#include <algorithm>
#include <limits>

#include "row_cuts.h"
#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::pipeline {
namespace {

using toolpath::Verdict;

/// How much of the shortest piece a row's end loses first where its lead or link fails.
constexpr double first_retreat = 0.125;

std::size_t failingCount(const MotionStage& motion) {
  return static_cast<std::size_t>(std::count_if(motion.verdicts.begin(), motion.verdicts.end(),
                                                [](const auto& verdict) { return verdict.verdict != Verdict::ok; }));
}

/// The motion with the start that a sample of the waypoints speaks for or, where waypoints fail with it, with the one
/// that all of them do if fewer fail then: between singular places a sample misses which way round the wrist goes.
MotionStage thoroughMotion(const PathStage& path, MotionStage sampled, const Cell& cell, const JobOptions& options,
                           const Progress& progress) {
  const std::size_t count = std::min<std::size_t>(toolpath::waypointCount(path.planned.path), 1000000);
  if (failingCount(sampled) == 0 || static_cast<std::size_t>(options.motion.candidate_waypoints) >= count) {
    return sampled;
  }
  JobOptions all = options;
  all.motion.candidate_waypoints = static_cast<int>(count);
  MotionStage compared = motionStage(path, cell, all, progress);
  return failingCount(compared) < failingCount(sampled) ? compared : sampled;
}

/// Cuts a path until nothing fails on the part.
class Cutting {
public:
  Cutting(const process::Planner& planner, const PathStage& whole, const scan::FittedScan& scan, const Cell& cell,
          const JobOptions& options, const Progress& progress)
      : planner_(planner),
        whole_(whole),
        scan_(scan),
        cell_(cell),
        options_(options),
        progress_(progress),
        cuts_(first_retreat * planner.shortestPiece()) {}

  /// Ends: every round leaves out contacts of the path that is left. Why it cannot go on; empty: nothing fails.
  std::string run(PathStage& path, MotionStage& motion) {
    std::size_t most = std::numeric_limits<std::size_t>::max();
    while (failingCount(motion) > 0) {
      const std::size_t failing = cuts_.cutContacts(path.planned, motion.verdicts);
      if (failing > most) {
        return "once the " + std::to_string(most) + " contacts that fail were left out, " + std::to_string(failing) +
               " others fail: leaving out does not help; see the verdicts on the whole path";
      }
      if (failing > 0) most = failing;
      // Leads and links are made anew where a row is cut: they count only once no contact fails any more.
      if (failing == 0 && !cuts_.cutRowEnds(path.planned, motion.verdicts)) return "what fails leads to no row";
      path = pathWithout(planner_, whole_, cuts_.places(), scan_, whole_.planned.path.frame, options_, progress_);
      if (path.planned.path.segments.empty()) return "nothing is left of the path that could be driven";
      motion = thoroughMotion(path, motionStage(path, cell_, options_, progress_), cell_, options_, progress_);
    }
    return "";
  }

  const Causes& causes() const { return cuts_.causes(); }

private:
  const process::Planner& planner_;
  const PathStage& whole_;
  const scan::FittedScan& scan_;
  const Cell& cell_;
  const JobOptions& options_;
  const Progress& progress_;
  RowCuts cuts_;
};

StageReport motionReport(const PathStage& whole, const PartialStage& stage) {
  StageReport report = {"motion",
                        toolpath::waypointCount(whole.planned.path),
                        stage.motion.verdicts.size() - failingCount(stage.motion),
                        {}};
  for (const auto& left_out : stage.left_out) {
    const std::string reason =
        left_out.kind == LeftOutKind::fails ? enumName(left_out.verdict.verdict) : enumName(left_out.kind);
    scan::addDropped(report.dropped, reason, 1);
  }
  return report;
}

}  // namespace

PartialStage partialStage(const process::Planner& planner, const PathStage& whole, const MotionStage& motion,
                          const scan::FittedScan& scan, const Cell& cell, const JobOptions& options,
                          const Progress& progress) {
  const bool is_air_run = options.program.dry_offset > 0.0;
  PathStage path = whole;
  MotionStage planned = is_air_run ? motionStage(whole, cell, options, progress) : motion;
  PartialStage stage = {whole, airRun(whole, cell, options.program), motion, {}, 0.0, ""};
  if (failingCount(planned) == 0) return stage;
  stage.motion = planned;  // what is refused, unless a path comes out
  planned = thoroughMotion(path, std::move(planned), cell, options, progress);
  Cutting cutting(planner, whole, scan, cell, options, progress);
  stage.refusal = cutting.run(path, planned);
  if (!stage.refusal.empty()) return stage;
  stage.left_out = leftOut(whole.planned, path.planned, cutting.causes(), planner.shortestPiece());
  stage.left_out_share = leftOutShare(whole.planned.path, path.planned.path);
  stage.driven = airRun(path, cell, options.program);
  if (is_air_run)
    planned = thoroughMotion(stage.driven, motionStage(stage.driven, cell, options, progress), cell, options, progress);
  stage.motion = std::move(planned);
  stage.path = std::move(path);
  stage.motion.report = motionReport(whole, stage);
  if (failingCount(stage.motion) > 0) {
    stage.refusal = std::to_string(failingCount(stage.motion)) +
                    " waypoints of what can be driven on the part fail in its air run: lower program.dry_offset";
  }
  return stage;
}

}  // namespace scan_to_path::pipeline
