// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::process {

/// How much of a part a path does not reach, seen along the scan's beam.
struct UncoveredArea {
  double area = 0.0;   ///< [m^2]
  double share = 0.0;  ///< of the outline's area
};

/// The part of the outline over which a ball that follows the rows leaves more than `height` [m] along the surface's
/// normal. Rows of which `allowances` [m], one a segment, leave stock on the surface count as not driven; empty means
/// none. Looked for on a square grid of 40000 points at most, which the area is as fine as along its border.
/// `path` is in the scan's cloud frame. O(points of the grid under the moves of the rows).
UncoveredArea uncoveredArea(const toolpath::ToolPath& path, const std::vector<double>& allowances,
                            const scan::FittedScan& scan, double ball_radius, double height);

}  // namespace scan_to_path::process
