// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/scene.h"

#include <utility>

#include "scan_to_path/common/error.h"

namespace scan_to_path::geometry {

PosedSurface::PosedSurface(std::shared_ptr<const Surface> surface, const Frame& T_base_workpiece)
    : surface_(std::move(surface)), T_base_workpiece_(T_base_workpiece), T_workpiece_base_(T_base_workpiece.inverse()) {
  if (!surface_) throw InputError("posed surface: no surface given");
}

std::optional<RayHit> PosedSurface::castRay(const Ray& ray, double max_distance) const {
  const Ray local = {T_workpiece_base_ * ray.origin, T_workpiece_base_.linear() * ray.direction};
  auto hit = surface_->castRay(local, max_distance);
  if (!hit) return std::nullopt;
  return RayHit{hit->distance, T_base_workpiece_ * hit->point, T_base_workpiece_.linear() * hit->normal};
}

SurfacePoint PosedSurface::closestPoint(const Vector3& p) const {
  const SurfacePoint local = surface_->closestPoint(T_workpiece_base_ * p);
  return {T_base_workpiece_ * local.point, T_base_workpiece_.linear() * local.normal};
}

Scene::Scene(std::vector<std::shared_ptr<const Surface>> surfaces) : surfaces_(std::move(surfaces)) {
  if (surfaces_.empty()) throw InputError("scene: no surface given");
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (!surfaces_[i]) throw InputError("scene: surface " + std::to_string(i) + " is missing");
  }
}

std::optional<Scene::Hit> Scene::castRayAtAll(const Ray& ray, double max_distance) const {
  std::optional<Hit> nearest;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const auto hit = surfaces_[i]->castRay(ray, nearest ? nearest->hit.distance : max_distance);
    if (hit && (!nearest || hit->distance < nearest->hit.distance)) nearest = Hit{*hit, i};
  }
  return nearest;
}

std::optional<RayHit> Scene::castRay(const Ray& ray, double max_distance) const {
  const auto nearest = castRayAtAll(ray, max_distance);
  if (!nearest) return std::nullopt;
  return nearest->hit;
}

SurfacePoint Scene::closestPoint(const Vector3& p) const {
  SurfacePoint nearest = surfaces_.front()->closestPoint(p);
  for (std::size_t i = 1; i < surfaces_.size(); ++i) {
    const SurfacePoint candidate = surfaces_[i]->closestPoint(p);
    if ((candidate.point - p).squaredNorm() < (nearest.point - p).squaredNorm()) nearest = candidate;
  }
  return nearest;
}

PrincipalCurvatures transformed(const Frame& T, const PrincipalCurvatures& curvatures) {
  return {curvatures.k_min, curvatures.k_max, T.linear() * curvatures.direction_min,
          T.linear() * curvatures.direction_max};
}

}  // namespace scan_to_path::geometry
