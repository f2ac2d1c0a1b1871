// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/partial_stage.h"

#include <algorithm>
#include <limits>
#include <map>

#include "scan_to_path/common/text.h"
#include "scan_to_path/scan/sample_rows.h"
#include "scan_to_path/toolpath/contact_frame.h"

namespace scan_to_path::pipeline {
namespace {

using process::PlannedPath;
using toolpath::Segment;
using toolpath::Verdict;
using toolpath::WaypointIndex;
using toolpath::WaypointVerdict;

/// How much of the shortest piece a row's end loses first where its lead or link fails.
constexpr double first_retreat = 0.125;

/// Why contacts of the whole path are left out.
using Causes = std::map<WaypointIndex, WaypointVerdict>;

const Segment& segmentOf(const PlannedPath& planned, int segment) {
  return planned.path.segments[static_cast<std::size_t>(segment)];
}

/// True when there was one that was not there before.
bool addCause(const PlannedPath& planned, const WaypointIndex& at, WaypointVerdict verdict, Causes& causes) {
  const auto source = process::sourceOf(planned.path, planned.pieces, at);
  if (!source) return false;
  verdict.segment = source->segment;
  verdict.index = source->index;
  return causes.emplace(*source, std::move(verdict)).second;
}

bool addContacts(const PlannedPath& planned, const std::vector<WaypointVerdict>& verdicts, Causes& causes) {
  bool added = false;
  for (const auto& verdict : verdicts) {
    if (verdict.verdict == Verdict::ok) continue;
    added |= addCause(planned, {verdict.segment, verdict.index}, verdict, causes);
  }
  return added;
}

/// An end of a row.
struct RowEnd {
  int segment = -1;
  bool is_start = true;
};

/// The row's end that a waypoint in the air leads to or comes from: leads belong to their row, the first two waypoints
/// of a link and of the retract go off the row before them.
RowEnd rowEndAt(const PlannedPath& planned, const WaypointIndex& at) {
  const Segment& segment = segmentOf(planned, at.segment);
  if (toolpath::isRow(segment)) return {at.segment, at.index < static_cast<int>(process::firstContact(segment))};
  const bool has_before = at.segment > 0;
  const bool has_after = at.segment + 1 < static_cast<int>(planned.path.segments.size());
  if (has_before && (at.index < 2 || !has_after)) return {at.segment - 1, false};
  return {at.segment + 1, true};
}

/// Leaves out the contacts within `length` along the row from one of its ends.
bool shorten(const PlannedPath& planned, const RowEnd& end, double length, WaypointVerdict verdict, Causes& causes) {
  const auto& waypoints = segmentOf(planned, end.segment).waypoints;
  const int count = static_cast<int>(waypoints.size());
  verdict.reason = "the way to it or from it: " + verdict.reason;
  const geometry::Frame* before = nullptr;
  double travelled = 0.0;
  bool added = false;
  for (int k = 0; k < count && travelled <= length; ++k) {
    const int i = end.is_start ? k : count - 1 - k;
    if (!toolpath::isContact(segmentOf(planned, end.segment), static_cast<std::size_t>(i))) continue;
    const geometry::Frame& pose = waypoints[static_cast<std::size_t>(i)].pose;
    if (before != nullptr) travelled += (pose.translation() - before->translation()).norm();
    added |= addCause(planned, {end.segment, i}, verdict, causes);
    before = &pose;
  }
  return added;
}

/// Leads and links are made anew where a row is cut: they count only once no contact fails any more.
bool addRowEnds(const PlannedPath& planned, const std::vector<WaypointVerdict>& verdicts, double length,
                Causes& causes) {
  bool added = false;
  for (const auto& verdict : verdicts) {
    if (verdict.verdict == Verdict::ok) continue;
    added |= shorten(planned, rowEndAt(planned, {verdict.segment, verdict.index}), length, verdict, causes);
  }
  return added;
}

std::set<WaypointIndex> placesOf(const Causes& causes) {
  std::set<WaypointIndex> places;
  for (const auto& [place, verdict] : causes) places.insert(places.end(), place);
  return places;
}

/// The cause nearest in space, for a contact that is left out with others.
const WaypointVerdict& nearestCause(const PlannedPath& whole, const Causes& causes, const Vector3& position) {
  const WaypointVerdict* nearest = &causes.begin()->second;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [place, verdict] : causes) {
    const auto& waypoint = segmentOf(whole, place.segment).waypoints[static_cast<std::size_t>(place.index)];
    const double distance = (waypoint.pose.translation() - position).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = &verdict;
  }
  return *nearest;
}

std::set<WaypointIndex> contactsOf(const PlannedPath& planned) {
  std::set<WaypointIndex> contacts;
  for (int s = 0; s < static_cast<int>(planned.path.segments.size()); ++s) {
    for (int i = 0; i < static_cast<int>(segmentOf(planned, s).waypoints.size()); ++i) {
      if (const auto source = process::sourceOf(planned.path, planned.pieces, {s, i})) contacts.insert(*source);
    }
  }
  return contacts;
}

std::vector<LeftOut> leftOut(const PlannedPath& whole, const PlannedPath& partial, const Causes& causes,
                             double shortest) {
  const std::set<WaypointIndex> driven = contactsOf(partial);
  std::vector<LeftOut> list;
  for (const WaypointIndex& at : contactsOf(whole)) {
    if (driven.count(at) > 0) continue;
    const Segment& row = segmentOf(whole, at.segment);
    LeftOut left_out;
    left_out.segment = row.name;
    left_out.position = row.waypoints[static_cast<std::size_t>(at.index)].pose.translation();
    const auto cause = causes.find(at);
    if (cause != causes.end()) {
      left_out.verdict = cause->second;
    } else {
      left_out.verdict = nearestCause(whole, causes, left_out.position);
      left_out.verdict.reason =
          "less than " + fixed(1e3 * shortest, 1) +
          " mm of the row is left here, or an earlier pass left it out; nearest: " + left_out.verdict.reason;
    }
    left_out.verdict.segment = at.segment;
    left_out.verdict.index = at.index;
    list.push_back(std::move(left_out));
  }
  return list;
}

/// Length of the moves on which the process works [m].
double workedLength(const toolpath::ToolPath& path) {
  double length = 0.0;
  for (const auto& segment : path.segments) {
    for (std::size_t i = 1; i < segment.waypoints.size(); ++i) {
      if (!segment.waypoints[i].process_on) continue;
      length += (segment.waypoints[i].pose.translation() - segment.waypoints[i - 1].pose.translation()).norm();
    }
  }
  return length;
}

std::size_t failingCount(const MotionStage& motion) {
  return static_cast<std::size_t>(std::count_if(motion.verdicts.begin(), motion.verdicts.end(),
                                                [](const auto& verdict) { return verdict.verdict != Verdict::ok; }));
}

StageReport motionReport(const PlannedPath& whole, const PartialStage& stage) {
  StageReport report = {
      "motion", toolpath::waypointCount(whole.path), stage.motion.verdicts.size() - failingCount(stage.motion), {}};
  for (const auto& left_out : stage.left_out) {
    scan::addDropped(report.dropped, enumName(left_out.verdict.verdict), 1);
  }
  return report;
}

}  // namespace

PartialStage partialStage(const process::Planner& planner, const PathStage& whole, const MotionStage& motion,
                          const scan::FittedScan& scan, const Cell& cell, const JobOptions& options,
                          const Progress& progress) {
  const double shortest = planner.shortestPiece();
  const bool is_air_run = options.program.dry_offset > 0.0;
  PathStage path = whole;
  MotionStage on_part = is_air_run ? motionStage(whole, cell, options, progress) : motion;
  PartialStage stage = {whole, airRun(whole, cell, options.program), motion, {}, 0.0, ""};
  if (failingCount(on_part) == 0) return stage;
  stage.motion = on_part;  // what is refused, unless a path comes out
  Causes causes;
  double retreat = first_retreat * shortest;
  // Ends: every round leaves out contacts of the path that is left.
  while (true) {
    if (!addContacts(path.planned, on_part.verdicts, causes)) {
      if (!addRowEnds(path.planned, on_part.verdicts, retreat, causes)) break;
      retreat *= 2.0;  // so that a link that cannot be had costs few rounds
    }
    path = pathWithout(planner, whole, placesOf(causes), scan, whole.planned.path.frame, options, progress);
    if (path.planned.path.segments.empty()) {
      stage.refusal = "nothing is left of the path that could be driven";
      return stage;
    }
    on_part = motionStage(path, cell, options, progress);
  }
  stage.left_out = leftOut(whole.planned, path.planned, causes, shortest);
  const double planned = workedLength(whole.planned.path);
  stage.left_out_share = planned > 0.0 ? 1.0 - workedLength(path.planned.path) / planned : 0.0;
  stage.driven = airRun(path, cell, options.program);
  stage.motion = is_air_run ? motionStage(stage.driven, cell, options, progress) : std::move(on_part);
  stage.path = std::move(path);
  stage.motion.report = motionReport(whole.planned, stage);
  if (failingCount(stage.motion) > 0) {
    stage.refusal = std::to_string(failingCount(stage.motion)) +
                    " waypoints of what can be driven on the part fail in its air run: lower program.dry_offset";
  }
  return stage;
}

std::vector<std::string> partialNotices(const std::vector<LeftOut>& left_out, double share, std::size_t most) {
  if (left_out.empty()) return {};
  std::vector<std::string> lines = {"PARTIAL PROGRAM: " + std::to_string(left_out.size()) + " waypoints, " +
                                    fixed(100.0 * share, 2) +
                                    " % of the planned cutting length, are left out. The part is NOT finished there."};
  std::size_t stretches = 0;
  for (auto begin = left_out.begin(); begin != left_out.end();) {
    auto end = begin + 1;
    while (end != left_out.end() && end->verdict.segment == begin->verdict.segment &&
           end->verdict.index == (end - 1)->verdict.index + 1 && end->verdict.verdict == begin->verdict.verdict) {
      ++end;
    }
    if (++stretches <= most) {
      lines.push_back("- left out: " + begin->segment + " waypoints " + std::to_string(begin->verdict.index) + " to " +
                      std::to_string((end - 1)->verdict.index) + ": " + enumName(begin->verdict.verdict));
    }
    begin = end;
  }
  if (stretches > most)
    lines.push_back("- and " + std::to_string(stretches - most) + " stretches more, see report.json");
  return lines;
}

}  // namespace scan_to_path::pipeline
