// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::process {

/// Where a segment's contacts come from in the path as first planned.
struct RowPart {
  int source = -1;  ///< segment; -1: no row (approach, link, retract)
  int first = 0;    ///< index there of the segment's first contact
};

/// Rows without leads and links, and where they come from.
struct CutRows {
  std::vector<toolpath::Segment> rows;
  std::vector<RowPart> parts;
  std::set<toolpath::WaypointIndex> left_out;  ///< every contact that is in none of the rows
};

/// The rows of a path without some of their contacts: the runs of contacts that are left, at least two of them and
/// `shortest` [m] along the row. The move to a run's first contact does not work. A row that is no longer whole has
/// its pieces named "<row>_part_0", … in driving order.
CutRows cutRows(const toolpath::ToolPath& whole, const std::set<toolpath::WaypointIndex>& left_out, double shortest);

/// The same for a path that goes over the same rows `passes` times, one pass after the other: what one pass leaves out
/// the next leaves out too, as it would cut deeper there than it is meant to.
CutRows cutPasses(const toolpath::ToolPath& whole, std::set<toolpath::WaypointIndex> left_out, int passes,
                  double shortest);

/// The waypoint of the path as first planned that a waypoint of `path` is; none for what is no contact of a row.
std::optional<toolpath::WaypointIndex> sourceOf(const toolpath::ToolPath& path, const std::vector<RowPart>& parts,
                                                const toolpath::WaypointIndex& at);

/// Index of a row's first contact; the number of waypoints when it has none.
std::size_t firstContact(const toolpath::Segment& segment);

}  // namespace scan_to_path::process
