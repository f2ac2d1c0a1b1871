// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "scan_to_path/mesh/triangle_mesh.h"

namespace scan_to_path::test {

/// A grid of (cells_u + 1) x (cells_v + 1) vertices over [0, 1]^2, two triangles per cell, normal along
/// d(shape)/du x d(shape)/dv.
inline mesh::TriangleMesh gridMesh(std::uint32_t cells_u, std::uint32_t cells_v,
                                   const std::function<Eigen::Vector3d(double, double)>& shape) {
  mesh::TriangleMesh result;
  for (std::uint32_t j = 0; j <= cells_v; ++j) {
    for (std::uint32_t i = 0; i <= cells_u; ++i) {
      result.vertices.push_back(shape(static_cast<double>(i) / cells_u, static_cast<double>(j) / cells_v));
    }
  }
  for (std::uint32_t j = 0; j < cells_v; ++j) {
    for (std::uint32_t i = 0; i < cells_u; ++i) {
      const std::uint32_t a = j * (cells_u + 1) + i;
      const std::uint32_t b = a + cells_u + 1;
      result.triangles.push_back({a, a + 1, b + 1});
      result.triangles.push_back({a, b + 1, b});
    }
  }
  return result;
}

/// A wavy sheet of about 0.2 m x 0.2 m.
inline mesh::TriangleMesh wavySheet(std::uint32_t cells) {
  return gridMesh(cells, cells, [](double u, double v) {
    return Eigen::Vector3d(0.2 * u, 0.2 * v, 0.01 * std::sin(20.0 * u) * std::cos(15.0 * v));
  });
}

/// The cube [0, side]^3 with outward winding.
inline mesh::TriangleMesh cubeMesh(double side) {
  mesh::TriangleMesh cube;
  for (int corner = 0; corner < 8; ++corner) {
    cube.vertices.push_back(side * Eigen::Vector3d(corner & 1, corner >> 1 & 1, corner >> 2));
  }
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return cube;
}

}  // namespace scan_to_path::test
