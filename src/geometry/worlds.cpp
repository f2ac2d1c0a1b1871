// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/worlds.h"

#include <algorithm>
#include <cmath>

#include "polynomial.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path::geometry {
namespace {

void requireRadius(const char* where, const char* quantity, double radius) {
  if (!(radius > 0.0 && std::isfinite(radius))) {
    throw InputError(where, quantity, std::to_string(radius) + " m", "positive and finite");
  }
}

/// The outward direction at p from a centre or axis point; any across `axis` when p lies on it.
Vector3 outward(const Vector3& from_centre, const Vector3& when_zero) {
  const double length = from_centre.norm();
  return length > 0.0 ? Vector3(from_centre / length) : when_zero;
}

/// The smaller root in (0, max_distance] of a t^2 + 2 b t + c = 0 with a > 0.
std::optional<double> firstQuadraticRoot(double a, double b, double c, double max_distance) {
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) return std::nullopt;
  // Without cancellation: the root of larger magnitude first, the other from their product c / a.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double t1 = q / a;
  const double t2 = q != 0.0 ? c / q : t1;
  const double near = std::min(t1, t2);
  const double t = near > 0.0 ? near : std::max(t1, t2);
  if (!(t > 0.0 && t <= max_distance)) return std::nullopt;
  return t;
}

Vector3 radial(const Vector3& p) { return {p.x(), p.y(), 0.0}; }

}  // namespace

std::optional<RayHit> Plane::castRay(const Ray& ray, double max_distance) const {
  const double t = -ray.origin.z() / ray.direction.z();
  if (!(t > 0.0 && t <= max_distance) || !std::isfinite(t)) return std::nullopt;
  Vector3 point = ray.origin + t * ray.direction;
  point.z() = 0.0;
  return RayHit{t, point, Vector3::UnitZ()};
}

SurfacePoint Plane::closestPoint(const Vector3& p) const { return {radial(p), Vector3::UnitZ()}; }

PrincipalCurvatures Plane::curvatures(const Vector3&) const { return {}; }

RoundSurface::RoundSurface(const char* name, double radius, const Vector3& across) : radius_(radius), across_(across) {
  requireRadius(name, "radius", radius);
}

std::optional<RayHit> RoundSurface::castRay(const Ray& ray, double max_distance) const {
  const Vector3 o = fromCentre(ray.origin);
  const Vector3 d = fromCentre(ray.direction);
  const double a = d.squaredNorm();
  if (a == 0.0) return std::nullopt;  // along the axis
  const auto t = firstQuadraticRoot(a, o.dot(d), (o.norm() - radius_) * (o.norm() + radius_), max_distance);
  if (!t) return std::nullopt;
  const SurfacePoint hit = closestPoint(ray.origin + *t * ray.direction);
  return RayHit{*t, hit.point, hit.normal};
}

SurfacePoint RoundSurface::closestPoint(const Vector3& p) const {
  const Vector3 from_centre = fromCentre(p);
  const Vector3 normal = outward(from_centre, Vector3::UnitX());
  return {p - from_centre + radius_ * normal, normal};
}

Sphere::Sphere(double radius) : RoundSurface("sphere", radius, {1.0, 1.0, 1.0}) {}

PrincipalCurvatures Sphere::curvatures(const Vector3& p) const {
  const Vector3 normal = closestPoint(p).normal;
  const Vector3 tangent = anyOrthogonal(normal);
  return {curvature(), curvature(), tangent, normal.cross(tangent)};
}

Cylinder::Cylinder(double radius) : RoundSurface("cylinder", radius, {1.0, 1.0, 0.0}) {}

PrincipalCurvatures Cylinder::curvatures(const Vector3& p) const {
  const Vector3 normal = closestPoint(p).normal;
  return {0.0, curvature(), Vector3::UnitZ(), Vector3::UnitZ().cross(normal)};
}

Torus::Torus(double major_radius, double minor_radius) : major_(major_radius), minor_(minor_radius) {
  requireRadius("torus", "minor radius", minor_radius);
  requireRadius("torus", "major radius", major_radius);
  if (minor_radius >= major_radius) {
    throw InputError("torus", "minor radius", std::to_string(minor_radius) + " m",
                     "below the major radius " + std::to_string(major_radius) + " m");
  }
}

Vector3 Torus::tubeCentre(const Vector3& p) const { return major_ * outward(radial(p), Vector3::UnitX()); }

std::optional<RayHit> Torus::castRay(const Ray& ray, double max_distance) const {
  // Measured from the ray's point closest to the torus' centre, so that far origins cost no digits:
  // (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2) with p = o + s d, o.d = 0.
  const double shift = -ray.origin.dot(ray.direction);
  const Vector3 o = ray.origin + shift * ray.direction;
  const Vector3& d = ray.direction;
  const double reach = major_ + minor_;
  const double half_chord = std::sqrt(std::max(0.0, reach * reach - o.squaredNorm()));
  if (half_chord == 0.0) return std::nullopt;
  const double k = o.squaredNorm() + major_ * major_ - minor_ * minor_;
  const double w = 4.0 * major_ * major_;
  const Polynomial quartic = {k * k - w * radial(o).squaredNorm(), -2.0 * w * radial(o).dot(radial(d)),
                              2.0 * k - w * radial(d).squaredNorm(), 0.0, 1.0};
  // The ray may graze the enclosing sphere from inside within rounding.
  const double margin = half_chord + 1e-9 * reach;
  for (const double s : realRoots(quartic, std::max(-margin, -shift), std::min(margin, max_distance - shift))) {
    if (!(s + shift > 0.0)) continue;
    const SurfacePoint hit = closestPoint(o + s * d);
    return RayHit{s + shift, hit.point, hit.normal};
  }
  return std::nullopt;
}

SurfacePoint Torus::closestPoint(const Vector3& p) const {
  const Vector3 centre = tubeCentre(p);
  const Vector3 normal = outward(p - centre, Vector3::UnitZ());
  return {centre + minor_ * normal, normal};
}

PrincipalCurvatures Torus::curvatures(const Vector3& p) const {
  const SurfacePoint closest = closestPoint(p);
  const Vector3 along = Vector3::UnitZ().cross(tubeCentre(p)).normalized();
  const double circle = radial(closest.point).dot(radial(closest.normal)) / radial(closest.point).squaredNorm();
  return {circle, 1.0 / minor_, along, along.cross(closest.normal)};
}

}  // namespace scan_to_path::geometry
