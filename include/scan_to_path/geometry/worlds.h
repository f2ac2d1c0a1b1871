// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/geometry/analytic_surface.h"

namespace scan_to_path::geometry {

/// The plane z = 0 without an end, outside above it.
class Plane : public AnalyticSurface {
public:
  std::optional<RayHit> castRay(const Ray& ray, double max_distance = std::numeric_limits<double>::infinity())
      const override;
  SurfacePoint closestPoint(const Vector3& p) const override;
  PrincipalCurvatures curvatures(const Vector3& p) const override;
};

/// A sphere about the origin.
class Sphere : public AnalyticSurface {
public:
  /// radius [m]; throws InputError unless it is positive and finite.
  explicit Sphere(double radius);
  std::optional<RayHit> castRay(const Ray& ray, double max_distance = std::numeric_limits<double>::infinity())
      const override;
  SurfacePoint closestPoint(const Vector3& p) const override;
  PrincipalCurvatures curvatures(const Vector3& p) const override;

private:
  double radius_;
};

/// A cylinder about the z axis, without ends.
class Cylinder : public AnalyticSurface {
public:
  /// radius [m]; throws InputError unless it is positive and finite.
  explicit Cylinder(double radius);
  std::optional<RayHit> castRay(const Ray& ray, double max_distance = std::numeric_limits<double>::infinity())
      const override;
  SurfacePoint closestPoint(const Vector3& p) const override;
  PrincipalCurvatures curvatures(const Vector3& p) const override;

private:
  double radius_;
};

/// A torus about the z axis.
class Torus : public AnalyticSurface {
public:
  /// Radius of the tube's centre circle and of the tube [m]; throws InputError unless 0 < minor < major.
  Torus(double major_radius, double minor_radius);
  std::optional<RayHit> castRay(const Ray& ray, double max_distance = std::numeric_limits<double>::infinity())
      const override;
  SurfacePoint closestPoint(const Vector3& p) const override;
  PrincipalCurvatures curvatures(const Vector3& p) const override;

private:
  Vector3 tubeCentre(const Vector3& p) const;

  double major_;
  double minor_;
};

}  // namespace scan_to_path::geometry
