// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::scan {

using geometry::Vector3;

/// Points in the scan frame of what stands in the way of a tool and is not fitted: the table, pieces too short to fit,
/// what was too near to be measured. Material, or unknown, from each point down.
using Obstacles = std::vector<Eigen::Vector3f>;

/// The highest point of each square of `side` [m] in the x-y plane, sorted by square: from a million points of a table
/// as many as a ball can tell apart. The same for any order of the points.
Obstacles highestPoints(const Obstacles& points, double side);

/// The side that a fit thins them to [m]: half a diagonal is 0.35 mm, which takes 3 um off a ball of 20 mm.
inline constexpr double obstacle_spacing = 0.0005;

}  // namespace scan_to_path::scan
