// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/tool_path.h"
#include "scan_to_path/toolpath/verdict.h"

namespace scan_to_path::process {

/// What a planner may work from; which of them it needs is the planner's business.
struct PlannerInput {
  const scan::FittedScan* scan = nullptr;
  std::string frame;  ///< name of the frame the input is in, e.g. "base_link"
};

/// A number worth reporting, with its unit.
struct Figure {
  std::string name;
  double value = 0.0;
  std::string unit;
};

/// A path and what is known against it.
struct PlannedPath {
  toolpath::ToolPath path;
  std::vector<toolpath::WaypointVerdict> findings;  ///< waypoints that are not ok (gouge), in path order
  std::vector<Figure> figures;                      ///< rows, pitch, length, scallop height, …
};

/// What turns a part into a tool path for one process.
class Planner {
public:
  virtual ~Planner() = default;

  /// Throws InputError when the input does not hold what the process needs, Interrupted when asked to stop.
  virtual PlannedPath plan(const PlannerInput& input, const Progress& progress) const = 0;
};

}  // namespace scan_to_path::process
