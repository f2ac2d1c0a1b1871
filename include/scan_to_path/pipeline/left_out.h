// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/process/planner.h"

namespace scan_to_path::pipeline {

/// Why a contact of the whole path is left out. The verdict's place is a contact of the whole path: the contact itself,
/// or the one at the row's end whose lead or link fails.
struct Cause {
  LeftOutKind kind = LeftOutKind::fails;
  toolpath::WaypointVerdict verdict;
};
using Causes = std::map<toolpath::WaypointIndex, Cause>;

/// Every contact of the whole path that is not in the partial one, in the whole path's order, with its own cause or,
/// for what is left out with others, the nearest one along its row or, where the row has none, on the pass before.
/// `shortest` is the planner's shortest piece [m].
std::vector<LeftOut> leftOut(const process::PlannedPath& whole, const process::PlannedPath& partial,
                             const Causes& causes, double shortest);

/// The share of the whole path's cutting length that the partial one does not have.
double leftOutShare(const toolpath::ToolPath& whole, const toolpath::ToolPath& partial);

/// What is left out as lines for a program's header: the share, then a line for each stretch of a row, at most `most`.
std::vector<std::string> partialNotices(const std::vector<LeftOut>& left_out, double share, std::size_t most = 40);

}  // namespace scan_to_path::pipeline
