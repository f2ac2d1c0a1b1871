// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/process/row_parts.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/tool_path.h"
#include "scan_to_path/toolpath/verdict.h"

namespace scan_to_path::process {

/// What a planner may work from; which of them it needs is the planner's business.
struct PlannerInput {
  const scan::FittedScan* scan = nullptr;
  std::string frame;  ///< name of the frame the input is in, e.g. "base_link"
  geometry::Frame T_input_workobject = geometry::Frame::Identity();  ///< frame of the user's region
};

/// A number worth reporting, with its unit.
struct Figure {
  std::string name;
  double value = 0.0;
  std::string unit;
};

/// A path and what is known against it. It goes over its rows `passes` times, one pass after the other.
struct PlannedPath {
  toolpath::ToolPath path;
  int passes = 1;
  std::vector<toolpath::WaypointVerdict> findings;  ///< waypoints that are not ok (gouge), in path order
  std::vector<Figure> figures;                      ///< rows, pitch, length, scallop height, …
  std::vector<double> allowances;                   ///< stock that each segment leaves on the surface [m]
  std::vector<RowPart> parts;                       ///< where each segment comes from in the path as first planned
};

/// What turns a part into a tool path for one process.
class Planner {
public:
  virtual ~Planner() = default;

  /// Throws InputError when the input does not hold what the process needs, Interrupted when asked to stop.
  virtual PlannedPath plan(const PlannerInput& input, const Progress& progress) const = 0;

  /// The path `whole`, which plan() made of the same input, without some contacts of its rows: rows are cut there,
  /// stretches shorter than shortestPiece() are left out too, and what leads to, from and between the rest is made
  /// anew, clear of all that `whole` touches. Findings and figures are those of the path that comes out (the rows'
  /// distances and scallop are the whole path's and left away), which has no segments when nothing is left.
  virtual PlannedPath without(const PlannedPath& whole, const std::set<toolpath::WaypointIndex>& left_out,
                              const PlannerInput& input, const Progress& progress) const = 0;

  /// The shortest stretch of a row that is worth a lead and a link of its own [m].
  virtual double shortestPiece() const = 0;
};

}  // namespace scan_to_path::process
