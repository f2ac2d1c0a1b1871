// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/analytic_surface.h"

#include <cmath>

namespace scan_to_path::geometry {

double signedDistance(const Surface& surface, const Vector3& p) {
  const SurfacePoint closest = surface.closestPoint(p);
  const Vector3 offset = p - closest.point;
  return std::copysign(offset.norm(), offset.dot(closest.normal));
}

PrincipalCurvatures principalCurvatures(double a, double b, double c, const Vector3& t1, const Vector3& t2) {
  const double mean = 0.5 * (a + c);
  const double radius = std::hypot(0.5 * (a - c), b);
  // Angle from t1 to the direction of the larger curvature; 0 at an umbilic, where every direction is principal.
  const double angle = radius > 0.0 ? 0.5 * std::atan2(b, 0.5 * (a - c)) : 0.0;
  PrincipalCurvatures result;
  result.k_min = mean - radius;
  result.k_max = mean + radius;
  result.direction_max = std::cos(angle) * t1 + std::sin(angle) * t2;
  result.direction_min = std::sin(angle) * t1 - std::cos(angle) * t2;
  return result;
}

}  // namespace scan_to_path::geometry
