// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/geometry/surface.h"

namespace scan_to_path::geometry {

/// A surface known by its equation: the truth that measured results are compared with.
class AnalyticSurface : public Surface {
public:
  /// Principal curvatures at the surface's closest point to p, exact. Convex seen from outside is positive.
  virtual PrincipalCurvatures curvatures(const Vector3& p) const = 0;
};

/// Distance from the surface's closest point to p [m], negative on the inside of its outward normal. Beyond the
/// border of an open surface the sign is the side of the tangent plane at the closest point.
double signedDistance(const Surface& surface, const Vector3& p);

/// Principal curvatures of the symmetric shape operator [[a, b], [b, c]] (rows and columns along the orthonormal
/// tangents t1, t2; convex positive).
PrincipalCurvatures principalCurvatures(double a, double b, double c, const Vector3& t1, const Vector3& t2);

}  // namespace scan_to_path::geometry
