// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/mesh_surface.h"

#include <utility>

namespace scan_to_path::mesh {

MeshSurface::MeshSurface(TriangleMesh mesh) : mesh_(std::move(mesh)), tree_(mesh_) {}

std::optional<geometry::RayHit> MeshSurface::castRay(const geometry::Ray& ray, double max_distance) const {
  const auto hit = tree_.castRay(ray, max_distance);
  if (!hit) return std::nullopt;
  return geometry::RayHit{hit->distance, ray.origin + hit->distance * ray.direction, mesh_.faceNormal(hit->triangle)};
}

geometry::SurfacePoint MeshSurface::closestPoint(const geometry::Vector3& p) const {
  const Bvh::Closest closest = tree_.closestPoint(p);
  return {closest.point, mesh_.faceNormal(closest.triangle)};
}

}  // namespace scan_to_path::mesh
