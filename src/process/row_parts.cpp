// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/row_parts.h"

#include "scan_to_path/toolpath/contact_frame.h"

namespace scan_to_path::process {
namespace {

using toolpath::Segment;
using toolpath::ToolPath;
using toolpath::WaypointIndex;

/// Waypoints [begin, end) of a row.
struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
};

double lengthOf(const Segment& row, const Run& run) {
  double length = 0.0;
  for (std::size_t i = run.begin + 1; i < run.end; ++i) {
    length += (row.waypoints[i].pose.translation() - row.waypoints[i - 1].pose.translation()).norm();
  }
  return length;
}

/// The runs of contacts that stay.
std::vector<Run> runsOf(const Segment& row, int segment, const std::set<WaypointIndex>& left_out) {
  std::vector<Run> runs;
  bool open = false;
  for (std::size_t i = 0; i < row.waypoints.size(); ++i) {
    const bool stays = toolpath::isContact(row, i) && left_out.count({segment, static_cast<int>(i)}) == 0;
    if (stays && !open) runs.push_back({i, i});
    if (stays) runs.back().end = i + 1;
    open = stays;
  }
  return runs;
}

Segment piece(const Segment& row, const Run& run) {
  Segment segment;
  segment.name = row.name;
  segment.waypoints.assign(row.waypoints.begin() + static_cast<std::ptrdiff_t>(run.begin),
                           row.waypoints.begin() + static_cast<std::ptrdiff_t>(run.end));
  segment.waypoints.front().process_on = false;  // the move to it is not a cut yet
  return segment;
}

}  // namespace

std::size_t firstContact(const Segment& segment) {
  std::size_t i = 0;
  while (i < segment.waypoints.size() && !toolpath::isContact(segment, i)) ++i;
  return i;
}

CutRows cutRows(const ToolPath& whole, const std::set<WaypointIndex>& left_out, double shortest) {
  CutRows cut;
  cut.left_out = left_out;
  for (std::size_t s = 0; s < whole.segments.size(); ++s) {
    const Segment& row = whole.segments[s];
    if (!toolpath::isRow(row)) continue;
    const int segment = static_cast<int>(s);
    const bool is_whole = left_out.lower_bound({segment, 0}) == left_out.lower_bound({segment + 1, 0});
    int part = 0;
    for (const Run& run : runsOf(row, segment, left_out)) {
      if (!is_whole && (run.end - run.begin < 2 || lengthOf(row, run) < shortest)) {
        for (std::size_t i = run.begin; i < run.end; ++i) cut.left_out.insert({segment, static_cast<int>(i)});
        continue;
      }
      cut.rows.push_back(piece(row, run));
      if (!is_whole) cut.rows.back().name += "_part_" + std::to_string(part++);
      cut.parts.push_back({segment, static_cast<int>(run.begin)});
    }
  }
  return cut;
}

CutRows cutPasses(const ToolPath& whole, std::set<WaypointIndex> left_out, int passes, double shortest) {
  std::vector<int> rows;
  for (std::size_t s = 0; s < whole.segments.size(); ++s) {
    if (toolpath::isRow(whole.segments[s])) rows.push_back(static_cast<int>(s));
  }
  const std::size_t per_pass = rows.size() / static_cast<std::size_t>(passes);
  CutRows cut = cutRows(whole, left_out, shortest);
  for (int pass = 1; pass < passes; ++pass) {
    for (std::size_t row = 0; row + per_pass < rows.size(); ++row) {
      const auto end = cut.left_out.lower_bound({rows[row] + 1, 0});
      for (auto at = cut.left_out.lower_bound({rows[row], 0}); at != end; ++at) {
        left_out.insert({rows[row + per_pass], at->index});
      }
    }
    cut = cutRows(whole, left_out, shortest);
  }
  return cut;
}

std::optional<WaypointIndex> sourceOf(const ToolPath& path, const std::vector<RowPart>& parts,
                                      const WaypointIndex& at) {
  const auto s = static_cast<std::size_t>(at.segment);
  const Segment& segment = path.segments[s];
  if (parts[s].source < 0 || !toolpath::isContact(segment, static_cast<std::size_t>(at.index))) return std::nullopt;
  return WaypointIndex{parts[s].source, parts[s].first + at.index - static_cast<int>(firstContact(segment))};
}

}  // namespace scan_to_path::process
