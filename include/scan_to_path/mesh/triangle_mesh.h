// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::mesh {

/// Indexed triangles, counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;               ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into vertices

  Eigen::AlignedBox3d bounds() const;
};

}  // namespace scan_to_path::mesh
