// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/process/row.h"
#include "scan_to_path/toolpath/scan_surface.h"

namespace scan_to_path::process {

/// The plan of rows given as pieces sorted by row: pieces numbered, and what lies between neighbours, which are rows
/// whose numbers follow each other in `numbers`, the rising row numbers of the whole part. `across` [unit] is the
/// rows' second axis in the scan plane. `whole` [sorted by row]: the rows that the pieces were cut out of, whose own
/// waypoints their scallops are judged at (widestScallopOfCut). Throws InputError when balls of neighbouring rows do
/// not meet.
RowPlan planOf(const std::vector<Row>& pieces, const std::vector<int>& numbers, const std::vector<Row>& whole,
               const Eigen::Vector2d& across, const toolpath::ScanSurface& surface, double ball_radius);

/// The pieces of rows that are driven when those named in `skip_rows` are not. Throws InputError when there is none to
/// begin with, and when none is left.
std::vector<Row> withoutSkipped(std::vector<Row> pieces, const std::string& skip_rows);

/// How many rows the pieces, sorted by row, make up.
int rowCount(const std::vector<Row>& pieces);

}  // namespace scan_to_path::process
