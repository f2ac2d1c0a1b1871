// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/height_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "scan_to_path/common/error.h"

namespace scan_to_path::geometry {
namespace {

using Vector2 = Eigen::Vector2d;

/// Rounding of the height above the surface at distance t along the ray [m]: less than this is on it.
double heightRounding(const Ray& ray, double t, const HeightJet& jet) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return epsilon * (t + ray.origin.lpNorm<1>() + std::abs(jet.z)) * (1.0 + std::abs(jet.zx) + std::abs(jet.zy));
}

Vector3 normalOf(const HeightJet& jet) { return Vector3(-jet.zx, -jet.zy, 1.0).normalized(); }

/// Narrows [begin, end] to where origin + t direction lies in [low, high]; one axis of the slab method.
void clip(double origin, double direction, double low, double high, double& begin, double& end) {
  if (direction == 0.0) {
    if (origin < low || origin > high) end = -1.0;
    return;
  }
  const double t1 = (low - origin) / direction;
  const double t2 = (high - origin) / direction;
  begin = std::max(begin, std::min(t1, t2));
  end = std::min(end, std::max(t1, t2));
}

/// How far f(t) >= 0 surely stays so with f(0) = value, f'(0) = slope, |f''| <= bending: the first positive root of
/// value + slope s - bending s^2 / 2, without cancellation.
double safeStep(double value, double slope, double bending) {
  const double root = std::sqrt(slope * slope + 2.0 * bending * value);
  if (slope > 0.0) return (slope + root) / bending;
  return 2.0 * value / (root - slope);
}

/// Half the squared distance to (x, y, f(x, y)) as a function of (x, y): gradient and Hessian.
struct Objective {
  Vector2 gradient;
  Eigen::Matrix2d hessian;
  Eigen::Matrix2d gauss_newton;  ///< without the curvature term: positive definite everywhere
};

Objective objectiveAt(const Vector3& p, const Vector2& xy, const HeightJet& jet) {
  const double dz = jet.z - p.z();
  Objective result;
  result.gradient = {xy.x() - p.x() + dz * jet.zx, xy.y() - p.y() + dz * jet.zy};
  result.gauss_newton << 1.0 + jet.zx * jet.zx, jet.zx * jet.zy, jet.zx * jet.zy, 1.0 + jet.zy * jet.zy;
  Eigen::Matrix2d bend;
  bend << jet.zxx, jet.zxy, jet.zxy, jet.zyy;
  result.hessian = result.gauss_newton + dz * bend;
  return result;
}

bool isPositiveDefinite(const Eigen::Matrix2d& m) {
  return m(0, 0) > 0.0 && m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0) > 1e-3 * m(0, 0) * m(0, 0);
}

/// Newton step that leaves out the coordinates that are held at the rectangle's border.
Vector2 newtonStep(const Objective& objective, const std::array<bool, 2>& is_held) {
  const Eigen::Matrix2d& m = isPositiveDefinite(objective.hessian) ? objective.hessian : objective.gauss_newton;
  const Vector2& g = objective.gradient;
  if (is_held[0] && is_held[1]) return Vector2::Zero();
  if (is_held[0]) return {0.0, -g.y() / m(1, 1)};
  if (is_held[1]) return {-g.x() / m(0, 0), 0.0};
  return -m.inverse() * g;
}

bool isHeld(double value, double low, double high, double slope) {
  return (value <= low && slope > 0.0) || (value >= high && slope < 0.0);
}

}  // namespace

HeightField::HeightField(const Rectangle& rectangle, const Bounds& bounds) : rectangle_(rectangle), bounds_(bounds) {
  const auto require = [](const char* quantity, double size) {
    if (!(size > 0.0 && std::isfinite(size))) {
      throw InputError("height field", quantity, std::to_string(size) + " m", "positive and finite");
    }
  };
  require("extent along x", rectangle.x_max - rectangle.x_min);
  require("extent along y", rectangle.y_max - rectangle.y_min);
  if (!(bounds.z_max >= bounds.z_min && bounds.bending >= 0.0 && std::isfinite(bounds.bending))) {
    throw InputError("height field", "bending", std::to_string(bounds.bending) + " 1/m",
                     "finite, over bounded heights");
  }
}

SurfacePoint HeightField::at(double x, double y) const {
  const HeightJet here = jet(x, y);
  return {{x, y, here.z}, normalOf(here)};
}

std::optional<RayHit> HeightField::castRay(const Ray& ray, double max_distance) const {
  double t = 0.0;
  double end = max_distance;
  clip(ray.origin.x(), ray.direction.x(), rectangle_.x_min, rectangle_.x_max, t, end);
  clip(ray.origin.y(), ray.direction.y(), rectangle_.y_min, rectangle_.y_max, t, end);
  clip(ray.origin.z(), ray.direction.z(), bounds_.z_min - 1e-6, bounds_.z_max + 1e-6, t, end);
  // Height above the surface along the ray has f'' = -d^T H d: bounded by the horizontal part of the direction.
  const double bending = bounds_.bending * ray.direction.head<2>().squaredNorm();
  constexpr int most_steps = 1000;  // only a ray that touches without crossing needs more than about 20
  for (int step = 0; step < most_steps && t <= end; ++step) {
    const Vector3 point = ray.origin + t * ray.direction;
    const HeightJet here = jet(point.x(), point.y());
    const double above = point.z() - here.z;
    const double slope = ray.direction.z() - here.zx * ray.direction.x() - here.zy * ray.direction.y();
    const double rounding = heightRounding(ray, t, here);
    const bool is_on = std::abs(above) <= rounding;
    if (is_on && t > rounding) return RayHit{t, {point.x(), point.y(), here.z}, normalOf(here)};
    const double side = is_on ? std::copysign(1.0, slope) : std::copysign(1.0, above);
    const double advance = safeStep(is_on ? 0.0 : std::abs(above), side * slope, bending);
    // A step that no longer changes t has found the hit to the last bit.
    if (t + advance == t) return RayHit{t, {point.x(), point.y(), here.z}, normalOf(here)};
    t += advance;
  }
  return std::nullopt;
}

Vector2 HeightField::clamped(const Vector2& xy) const {
  return {std::clamp(xy.x(), rectangle_.x_min, rectangle_.x_max),
          std::clamp(xy.y(), rectangle_.y_min, rectangle_.y_max)};
}

double HeightField::squaredDistance(const Vector3& p, const Vector2& xy) const {
  return (p - Vector3(xy.x(), xy.y(), jet(xy.x(), xy.y()).z)).squaredNorm();
}

Vector2 HeightField::footPoint(const Vector3& p, const Vector2& start) const {
  Vector2 xy = start;
  double distance = squaredDistance(p, xy);
  constexpr int most_iterations = 100;
  for (int i = 0; i < most_iterations; ++i) {
    const Objective objective = objectiveAt(p, xy, jet(xy.x(), xy.y()));
    const Vector2& g = objective.gradient;
    const std::array<bool, 2> is_held = {isHeld(xy.x(), rectangle_.x_min, rectangle_.x_max, g.x()),
                                         isHeld(xy.y(), rectangle_.y_min, rectangle_.y_max, g.y())};
    Vector2 step = newtonStep(objective, is_held);
    Vector2 next = clamped(xy + step);
    double next_distance = squaredDistance(p, next);
    // Far from the minimum a full step may climb; near it rounding decides, and the step is taken.
    for (int half = 0; half < 30 && next_distance > distance && step.norm() > 1e-7; ++half) {
      step *= 0.5;
      next = clamped(xy + step);
      next_distance = squaredDistance(p, next);
    }
    const double moved = (next - xy).norm();
    xy = next;
    distance = next_distance;
    if (moved <= 1e-14) break;
  }
  return xy;
}

Vector2 HeightField::farFootPoint(const Vector3& p, const Vector2& first) const {
  constexpr int cells = 24;
  const auto node = [&](int i, int j) {
    return Vector2(rectangle_.x_min + (rectangle_.x_max - rectangle_.x_min) * i / cells,
                   rectangle_.y_min + (rectangle_.y_max - rectangle_.y_min) * j / cells);
  };
  std::array<std::array<double, cells + 3>, cells + 3> distance;  // with a rim of infinities
  for (auto& row : distance) row.fill(std::numeric_limits<double>::infinity());
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) distance[i + 1][j + 1] = squaredDistance(p, node(i, j));
  }
  Vector2 best = first;
  double least = squaredDistance(p, first);
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const double here = distance[i + 1][j + 1];
      if (here > std::min({distance[i][j + 1], distance[i + 2][j + 1], distance[i + 1][j], distance[i + 1][j + 2]})) {
        continue;
      }
      const Vector2 candidate = footPoint(p, node(i, j));
      if (squaredDistance(p, candidate) >= least) continue;
      least = squaredDistance(p, candidate);
      best = candidate;
    }
  }
  return best;
}

SurfacePoint HeightField::closestPoint(const Vector3& p) const {
  Vector2 foot = footPoint(p, clamped(p.head<2>()));
  // A graph over a convex domain has reach >= 1 / bending (Federer 1959): a foot point within it is the nearest.
  const double reach_times_distance = bounds_.bending * std::sqrt(squaredDistance(p, foot));
  if (!(reach_times_distance < 1.0)) foot = farFootPoint(p, foot);
  return at(foot.x(), foot.y());
}

PrincipalCurvatures HeightField::curvatures(const Vector3& p) const {
  const SurfacePoint closest = closestPoint(p);
  const HeightJet here = jet(closest.point.x(), closest.point.y());
  const Vector3 t1 = Vector3(1.0, 0.0, here.zx).normalized();
  const Vector3 t2 = closest.normal.cross(t1);
  // Second fundamental form of a graph, Hessian / sqrt(1 + |grad|^2) = Hessian n_z, with the sign turned so that a
  // hill is positive; in the orthonormal basis t1, t2 it is the shape operator.
  const auto form = [&](const Vector3& u, const Vector3& v) {
    return -closest.normal.z() *
           (here.zxx * u.x() * v.x() + here.zxy * (u.x() * v.y() + u.y() * v.x()) + here.zyy * u.y() * v.y());
  };
  return principalCurvatures(form(t1, t1), form(t1, t2), form(t2, t2), t1, t2);
}

Saddle::Saddle(double radius, double half_side)
    : HeightField({-half_side, half_side, -half_side, half_side},
                  {-half_side * half_side / std::abs(radius), half_side * half_side / std::abs(radius),
                   1.0 / std::abs(radius)}),
      radius_(radius) {}

HeightJet Saddle::jet(double x, double y) const {
  return {x * y / radius_, y / radius_, x / radius_, 0.0, 1.0 / radius_, 0.0};
}

}  // namespace scan_to_path::geometry
