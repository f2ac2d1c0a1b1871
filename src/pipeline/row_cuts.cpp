// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "row_cuts.h"

#include <algorithm>

#include "scan_to_path/toolpath/contact_frame.h"

namespace scan_to_path::pipeline {
namespace {

using process::PlannedPath;
using toolpath::Segment;
using toolpath::Verdict;
using toolpath::WaypointIndex;
using toolpath::WaypointVerdict;

const Segment& segmentOf(const PlannedPath& planned, int segment) {
  return planned.path.segments[static_cast<std::size_t>(segment)];
}

/// The row's end that a waypoint in the air leads to or comes from, as a segment and whether it is its start: leads
/// belong to their row, the first two waypoints of a link and of the retract go off the row before them.
std::pair<int, bool> rowEndAt(const PlannedPath& planned, const WaypointIndex& at) {
  const Segment& segment = segmentOf(planned, at.segment);
  if (toolpath::isRow(segment)) return {at.segment, at.index < static_cast<int>(process::firstContact(segment))};
  const bool has_before = at.segment > 0;
  const bool has_after = at.segment + 1 < static_cast<int>(planned.path.segments.size());
  if (has_before && (at.index < 2 || !has_after)) return {at.segment - 1, false};
  return {at.segment + 1, true};
}

/// The places in the whole path of a row's contacts, from its start or from its end on.
std::vector<WaypointIndex> placesFrom(const PlannedPath& planned, int segment, bool is_start) {
  std::vector<WaypointIndex> places;
  for (int i = 0; i < static_cast<int>(segmentOf(planned, segment).waypoints.size()); ++i) {
    const auto source = process::sourceOf(planned.path, planned.parts, {segment, i});
    if (source) places.push_back(*source);
  }
  if (!is_start) std::reverse(places.begin(), places.end());
  return places;
}

}  // namespace

std::size_t RowCuts::cutContacts(const PlannedPath& planned, const std::vector<WaypointVerdict>& verdicts) {
  std::size_t failing = 0;
  for (WaypointVerdict verdict : verdicts) {
    if (verdict.verdict == Verdict::ok) continue;
    const auto source = process::sourceOf(planned.path, planned.parts, {verdict.segment, verdict.index});
    if (!source) continue;
    verdict.segment = source->segment;
    verdict.index = source->index;
    failing += causes_.emplace(*source, Cause{LeftOutKind::fails, std::move(verdict)}).second ? 1 : 0;
  }
  return failing;
}

bool RowCuts::cutRowEnds(const PlannedPath& planned, const std::vector<WaypointVerdict>& verdicts) {
  std::map<std::pair<int, bool>, WaypointVerdict> ends;  // the first verdict of each: an end goes back once a round
  for (const WaypointVerdict& verdict : verdicts) {
    if (verdict.verdict == Verdict::ok) continue;
    ends.emplace(rowEndAt(planned, {verdict.segment, verdict.index}), verdict);
  }
  const std::size_t before = causes_.size();
  for (const auto& [end, verdict] : ends) shorten(planned, end.first, end.second, verdict);
  return causes_.size() > before;
}

void RowCuts::shorten(const PlannedPath& planned, int segment, bool is_start, WaypointVerdict verdict) {
  const std::vector<WaypointIndex> places = placesFrom(planned, segment, is_start);
  if (places.empty()) return;
  const auto known = retreats_.find({places.front(), is_start});
  const double retreat = known != retreats_.end() ? known->second : first_retreat_;
  verdict.segment = places.front().segment;
  verdict.index = places.front().index;
  const auto& waypoints = segmentOf(planned, segment).waypoints;
  const auto first = static_cast<std::ptrdiff_t>(process::firstContact(segmentOf(planned, segment)));
  const auto contact = [&](std::size_t k) {
    const auto along = static_cast<std::ptrdiff_t>(is_start ? k : places.size() - 1 - k);
    return waypoints[static_cast<std::size_t>(first + along)].pose.translation();
  };
  double travelled = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k > 0) travelled += (contact(k) - contact(k - 1)).norm();
    if (travelled > retreat) {
      retreats_[{places[k], is_start}] = 2.0 * retreat;  // so that a link that cannot be had costs few rounds
      return;
    }
    causes_.emplace(places[k], Cause{LeftOutKind::way_fails, verdict});
  }
}

std::set<WaypointIndex> RowCuts::places() const {
  std::set<WaypointIndex> places;
  for (const auto& [place, cause] : causes_) places.insert(places.end(), place);
  return places;
}

}  // namespace scan_to_path::pipeline
