// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "scan_to_path/geometry/surface.h"

namespace scan_to_path::geometry {

/// A surface placed somewhere else: answers are in the base frame.
class PosedSurface : public Surface {
public:
  /// Throws InputError without a surface.
  PosedSurface(std::shared_ptr<const Surface> surface, const Frame& T_base_workpiece);

  std::optional<RayHit> castRay(const Ray& ray,
                                double max_distance = std::numeric_limits<double>::infinity()) const override;
  SurfacePoint closestPoint(const Vector3& p) const override;

  const Frame& T_base_workpiece() const { return T_base_workpiece_; }

private:
  std::shared_ptr<const Surface> surface_;
  Frame T_base_workpiece_;
  Frame T_workpiece_base_;
};

/// Several surfaces seen as one, e.g. a part and the table it lies on.
class Scene : public Surface {
public:
  struct Hit {
    RayHit hit;
    std::size_t surface = 0;  ///< index in the order of the constructor's list
  };

  /// Throws InputError for an empty list or a missing surface.
  explicit Scene(std::vector<std::shared_ptr<const Surface>> surfaces);

  /// The nearest hit of all surfaces and whose it is; the earlier surface wins a tie.
  std::optional<Hit> castRayAtAll(const Ray& ray, double max_distance = std::numeric_limits<double>::infinity()) const;

  std::optional<RayHit> castRay(const Ray& ray,
                                double max_distance = std::numeric_limits<double>::infinity()) const override;
  SurfacePoint closestPoint(const Vector3& p) const override;

private:
  std::vector<std::shared_ptr<const Surface>> surfaces_;
};

/// Curvatures of a surface that T moves: their directions turn with it.
PrincipalCurvatures transformed(const Frame& T, const PrincipalCurvatures& curvatures);

}  // namespace scan_to_path::geometry
