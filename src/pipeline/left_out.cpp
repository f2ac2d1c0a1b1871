// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/left_out.h"

#include <set>

#include "scan_to_path/common/text.h"
#include "scan_to_path/toolpath/contact_frame.h"

namespace scan_to_path::pipeline {
namespace {

using process::PlannedPath;
using toolpath::Segment;
using toolpath::WaypointIndex;

const Segment& rowOf(const PlannedPath& planned, int segment) {
  return planned.path.segments[static_cast<std::size_t>(segment)];
}

/// The contacts of the whole path that a path made of it has.
std::set<WaypointIndex> contactsOf(const PlannedPath& planned) {
  std::set<WaypointIndex> contacts;
  for (int s = 0; s < static_cast<int>(planned.path.segments.size()); ++s) {
    for (int i = 0; i < static_cast<int>(rowOf(planned, s).waypoints.size()); ++i) {
      if (const auto source = process::sourceOf(planned.path, planned.parts, {s, i})) contacts.insert(*source);
    }
  }
  return contacts;
}

/// The row that each row goes over again on a later pass; -1 for those of the first pass.
std::map<int, int> rowsOfThePassBefore(const PlannedPath& whole) {
  std::vector<int> rows;
  for (int s = 0; s < static_cast<int>(whole.path.segments.size()); ++s) {
    if (toolpath::isRow(rowOf(whole, s))) rows.push_back(s);
  }
  const std::size_t per_pass = rows.size() / static_cast<std::size_t>(whole.passes);
  std::map<int, int> before;
  for (std::size_t k = 0; k < rows.size(); ++k) before[rows[k]] = k < per_pass ? -1 : rows[k - per_pass];
  return before;
}

/// The cause that is the fewest waypoints off along the row; null when the row has none.
const Cause* nearestOnRow(const Causes& causes, const WaypointIndex& at) {
  const auto after = causes.lower_bound(at);
  const bool has_after = after != causes.end() && after->first.segment == at.segment;
  const auto before = after == causes.begin() ? causes.end() : std::prev(after);
  const bool has_before = before != causes.end() && before->first.segment == at.segment;
  if (!has_before) return has_after ? &after->second : nullptr;
  const bool is_after_nearer = has_after && after->first.index - at.index < at.index - before->first.index;
  return is_after_nearer ? &after->second : &before->second;
}

/// Down the passes to the first on which the row has a cause. A row is cut for a cause of its own, or for what an
/// earlier pass left out, so one of them has it.
const Cause& nearestCause(const Causes& causes, const std::map<int, int>& pass_before, WaypointIndex at) {
  for (; at.segment >= 0; at.segment = pass_before.at(at.segment)) {
    if (const Cause* cause = nearestOnRow(causes, at)) return *cause;
  }
  return causes.begin()->second;
}

std::string noticeText(const LeftOut& left_out) {
  if (left_out.kind == LeftOutKind::with_others) return "with others";
  const std::string verdict = enumName(left_out.verdict.verdict);
  return left_out.kind == LeftOutKind::fails ? verdict : "the way to it or from it, " + verdict;
}

}  // namespace

std::vector<LeftOut> leftOut(const PlannedPath& whole, const PlannedPath& partial, const Causes& causes,
                             double shortest) {
  const std::set<WaypointIndex> driven = contactsOf(partial);
  const std::map<int, int> pass_before = rowsOfThePassBefore(whole);
  std::vector<LeftOut> list;
  for (const WaypointIndex& at : contactsOf(whole)) {
    if (driven.count(at) > 0) continue;
    const Segment& row = rowOf(whole, at.segment);
    const auto own = causes.find(at);
    const Cause& cause = own != causes.end() ? own->second : nearestCause(causes, pass_before, at);
    LeftOut left_out;
    left_out.segment = row.name;
    left_out.index = at.index;
    left_out.position = row.waypoints[static_cast<std::size_t>(at.index)].pose.translation();
    left_out.kind = own != causes.end() ? cause.kind : LeftOutKind::with_others;
    left_out.verdict = cause.verdict;
    left_out.caused_by = rowOf(whole, cause.verdict.segment).name;
    if (left_out.kind == LeftOutKind::way_fails) left_out.reason = "the way to it or from it fails";
    if (left_out.kind == LeftOutKind::with_others) {
      left_out.reason =
          "less than " + fixed(1e3 * shortest, 1) + " mm of the row is left here, or an earlier pass left it out";
    }
    list.push_back(std::move(left_out));
  }
  return list;
}

double leftOutShare(const toolpath::ToolPath& whole, const toolpath::ToolPath& partial) {
  const double planned = toolpath::travelOf(whole).worked;
  return planned > 0.0 ? 1.0 - toolpath::travelOf(partial).worked / planned : 0.0;
}

std::vector<std::string> partialNotices(const std::vector<LeftOut>& left_out, double share, std::size_t most) {
  if (left_out.empty()) return {};
  std::vector<std::string> lines = {"PARTIAL PROGRAM: " + std::to_string(left_out.size()) + " waypoints, " +
                                    fixed(100.0 * share, 2) +
                                    " % of the planned cutting length, are left out. The part is NOT finished there."};
  std::size_t stretches = 0;
  for (auto begin = left_out.begin(); begin != left_out.end();) {
    auto end = begin + 1;
    while (end != left_out.end() && end->segment == begin->segment && end->index == (end - 1)->index + 1 &&
           noticeText(*end) == noticeText(*begin)) {
      ++end;
    }
    if (++stretches <= most) {
      lines.push_back("- left out: " + begin->segment + " waypoints " + std::to_string(begin->index) + " to " +
                      std::to_string((end - 1)->index) + ": " + noticeText(*begin));
    }
    begin = end;
  }
  if (stretches > most)
    lines.push_back("- and " + std::to_string(stretches - most) + " stretches more, see report.json");
  return lines;
}

}  // namespace scan_to_path::pipeline
