// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/mesh/triangle_mesh.h"

namespace scan_to_path::mesh {

/// Bounding-volume tree over a mesh's triangles: binary, split by the surface-area heuristic over 16 bins (Wald 2007),
/// in one flat array. It keeps its own copy of the triangles in the order of the leaves.
class Bvh {
public:
  struct Hit {
    double distance = 0.0;       ///< along the ray [m]
    std::uint32_t triangle = 0;  ///< index in the mesh
  };

  struct Closest {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [m]
    double squared_distance = 0.0;                    ///< [m^2]
    std::uint32_t triangle = 0;                       ///< index in the mesh
  };

  /// Throws InputError for a mesh without triangles. Precondition: indices are in range and vertices finite.
  explicit Bvh(const TriangleMesh& mesh);

  /// First triangle hit at a distance in (0, max_distance], from either side. Watertight: a ray cannot pass between
  /// two triangles that share an edge or a vertex (Woop, Benthin and Wald 2013); of equal distances the lower index.
  std::optional<Hit> castRay(const geometry::Ray& ray,
                             double max_distance = std::numeric_limits<double>::infinity()) const;

  /// Closest point of all triangles. Where triangles share it, the one is given that p lies most in front of or
  /// behind, so that the sign of (p - point) . normal tells the side at an edge too.
  Closest closestPoint(const Eigen::Vector3d& p) const;

  std::size_t nodeCount() const { return nodes_.size(); }

  /// A box and what is in it: `count` triangles from `first` on, or, with count 0, the node `first`.
  struct Child {
    std::array<float, 3> low;
    std::array<float, 3> high;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  using Node = std::array<Child, 2>;  // one cache line

  struct Triangle {
    std::array<Eigen::Vector3d, 3> corners;
    std::uint32_t index = 0;
  };

private:
  Child root_;
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
};

}  // namespace scan_to_path::mesh
