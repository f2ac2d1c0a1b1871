// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::geometry {

/// Half-line with a unit direction.
struct Ray {
  Vector3 origin = Vector3::Zero();      ///< [m]
  Vector3 direction = Vector3::UnitZ();  ///< unit
};

struct RayHit {
  double distance = 0.0;              ///< along the ray [m]
  Vector3 point = Vector3::Zero();    ///< [m]
  Vector3 normal = Vector3::UnitZ();  ///< unit, outward of the part (not turned towards the ray)
};

struct SurfacePoint {
  Vector3 point = Vector3::Zero();    ///< [m]
  Vector3 normal = Vector3::UnitZ();  ///< unit, outward of the part
};

/// A part's surface, whatever it is made of. Values are in the surface's own frame.
class Surface {
public:
  virtual ~Surface() = default;

  /// First hit at a distance in (0, max_distance]; nothing when the ray misses.
  virtual std::optional<RayHit> castRay(const Ray& ray,
                                        double max_distance = std::numeric_limits<double>::infinity()) const = 0;

  /// The surface's closest point to p.
  virtual SurfacePoint closestPoint(const Vector3& p) const = 0;
};

/// Signed principal curvatures at a surface point: convex (seen from outside) is positive.
struct PrincipalCurvatures {
  double k_min = 0.0;                        ///< [1/m]
  double k_max = 0.0;                        ///< [1/m]
  Vector3 direction_min = Vector3::UnitX();  ///< unit, tangent
  Vector3 direction_max = Vector3::UnitY();  ///< unit, tangent
};

}  // namespace scan_to_path::geometry
