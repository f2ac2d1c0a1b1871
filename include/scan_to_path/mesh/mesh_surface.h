// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/mesh/bvh.h"
#include "scan_to_path/mesh/triangle_mesh.h"

namespace scan_to_path::mesh {

/// A mesh as a part's surface. Normals are those of the faces, by their winding.
class MeshSurface : public geometry::Surface {
public:
  /// Throws InputError for a mesh without triangles.
  explicit MeshSurface(TriangleMesh mesh);

  std::optional<geometry::RayHit> castRay(const geometry::Ray& ray,
                                          double max_distance = std::numeric_limits<double>::infinity()) const override;
  geometry::SurfacePoint closestPoint(const geometry::Vector3& p) const override;

  const TriangleMesh& mesh() const { return mesh_; }
  const Bvh& tree() const { return tree_; }

private:
  TriangleMesh mesh_;
  Bvh tree_;
};

}  // namespace scan_to_path::mesh
