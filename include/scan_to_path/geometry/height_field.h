// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/geometry/analytic_surface.h"
#include "scan_to_path/geometry/height_jet.h"

namespace scan_to_path::geometry {

/// x and y range of a height field, its border included [m].
struct Rectangle {
  double x_min = 0.0;
  double x_max = 0.0;
  double y_min = 0.0;
  double y_max = 0.0;

  bool contains(double x, double y) const { return x >= x_min && x <= x_max && y >= y_min && y <= y_max; }
};

/// The open surface z = f(x, y) over a rectangle, outside above it. Rays beside the rectangle pass.
class HeightField : public AnalyticSurface {
public:
  /// What is known of f over the whole rectangle: that is what makes the ray cast and the closest point safe.
  struct Bounds {
    double z_min = 0.0;    ///< not above any height [m]
    double z_max = 0.0;    ///< not below any height [m]
    double bending = 0.0;  ///< not below the spectral norm of any Hessian of f [1/m]
  };

  /// Throws InputError for an empty rectangle or bounds that are not finite.
  HeightField(const Rectangle& rectangle, const Bounds& bounds);

  /// f and its derivatives, exact; also right outside of the rectangle.
  virtual HeightJet jet(double x, double y) const = 0;

  /// The point above (x, y) and the normal there.
  SurfacePoint at(double x, double y) const;

  const Rectangle& rectangle() const { return rectangle_; }

  /// Steps along the ray so far as f's bending leaves no room for a hit: never past one, and quadratic near it.
  std::optional<RayHit> castRay(const Ray& ray,
                                double max_distance = std::numeric_limits<double>::infinity()) const override;

  /// Newton's method on the foot point within the rectangle. Exact nearest within 1 / bending of the surface, where
  /// a foot point is the only one; farther away the best of a search from all minima over a grid.
  SurfacePoint closestPoint(const Vector3& p) const override;

  PrincipalCurvatures curvatures(const Vector3& p) const override;

private:
  Eigen::Vector2d clamped(const Eigen::Vector2d& xy) const;
  double squaredDistance(const Vector3& p, const Eigen::Vector2d& xy) const;
  Eigen::Vector2d footPoint(const Vector3& p, const Eigen::Vector2d& start) const;
  Eigen::Vector2d farFootPoint(const Vector3& p, const Eigen::Vector2d& first) const;

  Rectangle rectangle_;
  Bounds bounds_;
};

/// z = 0 over a rectangle.
class FlatPart : public HeightField {
public:
  explicit FlatPart(const Rectangle& rectangle) : HeightField(rectangle, {}) {}
  HeightJet jet(double, double) const override { return {}; }
};

/// z = x y / radius over a square about the origin: Gaussian curvature -1 / radius^2 at the middle.
class Saddle : public HeightField {
public:
  /// radius [m], half the square's side [m].
  Saddle(double radius, double half_side);
  HeightJet jet(double x, double y) const override;

private:
  double radius_;
};

/// The S-shaped part on which all figures of this package are measured: x in [0, 0.24], y in [0, 0.16] m,
/// z = 0.020 sin(2 pi (x - 0.12) / 0.24) + 0.004 cos(pi (y - 0.08) / 0.16)
///   + 0.003 sin(2 pi x / 0.24) sin(pi y / 0.16).
class SPart : public HeightField {
public:
  SPart();
  HeightJet jet(double x, double y) const override;
};

}  // namespace scan_to_path::geometry
