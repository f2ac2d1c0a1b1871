// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::tools {

/// Normals at the chosen points by PCL: least principal component of the `neighbours` nearest of all points, unit, on
/// the side of `towards`. What the figures compare the scan-line method with.
std::vector<geometry::Vector3> pcaNormals(const std::vector<geometry::Vector3>& points,
                                          const std::vector<std::size_t>& chosen, int neighbours,
                                          const geometry::Vector3& towards);

}  // namespace scan_to_path::tools
