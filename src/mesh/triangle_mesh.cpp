// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/triangle_mesh.h"

namespace scan_to_path::mesh {
namespace {

/// Twice the triangle's area times its outward unit normal.
Eigen::Vector3d areaVector(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
}

}  // namespace

Eigen::AlignedBox3d TriangleMesh::bounds() const {
  Eigen::AlignedBox3d box;
  for (const auto& vertex : vertices) box.extend(vertex);
  return box;
}

double TriangleMesh::area() const {
  double sum = 0.0;
  for (const auto& triangle : triangles) sum += areaVector(*this, triangle).norm();
  return 0.5 * sum;
}

Eigen::Vector3d TriangleMesh::faceNormal(std::size_t triangle) const {
  return areaVector(*this, triangles[triangle]).normalized();
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (auto& vertex : mesh.vertices) vertex *= factor;
  return mesh;
}

}  // namespace scan_to_path::mesh
