// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::mesh {

/// Indexed triangles, counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;                ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into vertices

  /// Box of all vertices [m]; empty (isEmpty()) without any.
  Eigen::AlignedBox3d bounds() const;

  /// Sum of the triangles' areas [m^2].
  double area() const;

  /// Outward unit normal of a triangle by its winding. Precondition: the triangle is not degenerate.
  Eigen::Vector3d faceNormal(std::size_t triangle) const;
};

/// The mesh with all coordinates times `factor`, for a file that is not in metres.
TriangleMesh scaled(TriangleMesh mesh, double factor);

}  // namespace scan_to_path::mesh
