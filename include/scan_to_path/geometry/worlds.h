// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/geometry/analytic_surface.h"

namespace scan_to_path::geometry {

/// The plane z = 0 without an end, outside above it.
class Plane : public AnalyticSurface {
public:
  std::optional<RayHit> castRay(const Ray& ray,
                                double max_distance = std::numeric_limits<double>::infinity()) const override;
  SurfacePoint closestPoint(const Vector3& p) const override;
  PrincipalCurvatures curvatures(const Vector3& p) const override;
};

/// All points at one distance from the origin, or from the z axis.
class RoundSurface : public AnalyticSurface {
public:
  std::optional<RayHit> castRay(const Ray& ray,
                                double max_distance = std::numeric_limits<double>::infinity()) const override;
  SurfacePoint closestPoint(const Vector3& p) const override;

protected:
  /// `across` is 1 for every axis that the distance counts along, else 0. Throws InputError, saying `name`, unless the
  /// radius is positive and finite.
  RoundSurface(const char* name, double radius, const Vector3& across);
  double curvature() const { return 1.0 / radius_; }

private:
  Vector3 fromCentre(const Vector3& v) const { return across_.cwiseProduct(v); }

  double radius_;
  Vector3 across_;
};

/// A sphere about the origin.
class Sphere : public RoundSurface {
public:
  /// radius [m]; throws InputError unless it is positive and finite.
  explicit Sphere(double radius);
  PrincipalCurvatures curvatures(const Vector3& p) const override;
};

/// A cylinder about the z axis, without ends.
class Cylinder : public RoundSurface {
public:
  /// As Sphere's.
  explicit Cylinder(double radius);
  PrincipalCurvatures curvatures(const Vector3& p) const override;
};

/// A torus about the z axis.
class Torus : public AnalyticSurface {
public:
  /// Radius of the tube's centre circle and of the tube [m]; throws InputError unless 0 < minor < major.
  Torus(double major_radius, double minor_radius);
  std::optional<RayHit> castRay(const Ray& ray,
                                double max_distance = std::numeric_limits<double>::infinity()) const override;
  SurfacePoint closestPoint(const Vector3& p) const override;
  PrincipalCurvatures curvatures(const Vector3& p) const override;

private:
  Vector3 tubeCentre(const Vector3& p) const;

  double major_;
  double minor_;
};

}  // namespace scan_to_path::geometry
