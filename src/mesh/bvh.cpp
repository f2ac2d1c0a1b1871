// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/bvh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bvh_builder.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path::mesh {
namespace {

using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Subtrees still to be visited, with a lower bound of what they can give.
class Stack {
public:
  bool isEmpty() const { return size_ == 0; }
  void push(const Bvh::Child& child, double bound) { entries_[size_++] = {&child, bound}; }
  std::pair<const Bvh::Child*, double> pop() { return entries_[--size_]; }

private:
  std::array<std::pair<const Bvh::Child*, double>, deepest_bvh + 1> entries_;
  std::size_t size_ = 0;
};

/// Puts both children on the stack, the nearer one on top, unless their bound is beyond the limit.
template <class Bound>
void pushChildren(const Bvh::Node& node, const Bound& bound, double limit, Stack& stack) {
  const double first = bound(node[0]);
  const double second = bound(node[1]);
  const int nearer = first <= second ? 0 : 1;
  const double near = std::min(first, second);
  const double far = std::max(first, second);
  if (far <= limit) stack.push(node[1 - nearer], far);
  if (near <= limit) stack.push(node[nearer], near);
}

/// A ray made ready for boxes and for triangles (Woop, Benthin and Wald 2013): the axis along which it runs most
/// becomes z, and a shear makes the others zero.
class PreparedRay {
public:
  explicit PreparedRay(const geometry::Ray& ray) : origin_(ray.origin) {
    ray.direction.cwiseAbs().maxCoeff(&z_);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_x_ = ray.direction[x_] / ray.direction[z_];
    shear_y_ = ray.direction[y_] / ray.direction[z_];
    scale_z_ = 1.0 / ray.direction[z_];
    // Finite, so that a box's plane through the origin gives 0 and not NaN.
    constexpr double largest = 1e300;
    for (int i = 0; i < 3; ++i) inverse_[i] = std::clamp(1.0 / ray.direction[i], -largest, largest);
  }

  /// Distance at which the ray enters the box, 0 from inside; infinity when it does not before `end`.
  double enter(const Bvh::Child& child, double end) const {
    double begin = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double t1 = (child.low[i] - origin_[i]) * inverse_[i];
      const double t2 = (child.high[i] - origin_[i]) * inverse_[i];
      begin = std::max(begin, std::min(t1, t2));
      end = std::min(end, std::max(t1, t2));
    }
    // Three roundings in each of the two.
    return begin <= end * (1.0 + 1e-15) ? begin : infinity;
  }

  /// Distance to the triangle's plane where the ray passes within its edges; NaN otherwise.
  double hit(const Bvh::Triangle& triangle) const {
    const Vector3d a = sheared(triangle.corners[0]);
    const Vector3d b = sheared(triangle.corners[1]);
    const Vector3d c = sheared(triangle.corners[2]);
    // Twice the signed areas under each edge. A neighbour computes the shared edge's with the opposite sign to the
    // last bit, so that one of both contains the ray.
    const double u = c.x() * b.y() - c.y() * b.x();
    const double v = a.x() * c.y() - a.y() * c.x();
    const double w = b.x() * a.y() - b.y() * a.x();
    const bool is_inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    const double determinant = u + v + w;
    if (!is_inside || determinant == 0.0) return std::nan("");
    return (u * a.z() + v * b.z() + w * c.z()) / determinant;
  }

private:
  Vector3d sheared(const Vector3d& corner) const {
    const Vector3d p = corner - origin_;
    return {p[x_] - shear_x_ * p[z_], p[y_] - shear_y_ * p[z_], scale_z_ * p[z_]};
  }

  Vector3d origin_;
  Vector3d inverse_;
  int x_ = 0;
  int y_ = 1;
  int z_ = 2;
  double shear_x_ = 0.0;
  double shear_y_ = 0.0;
  double scale_z_ = 1.0;
};

/// Closest point of a triangle by the Voronoi region that p is in (Ericson 2005, section 5.1.5).
Vector3d closestOnTriangle(const Vector3d& p, const std::array<Vector3d, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vector3d ab = b - a;
  const Vector3d ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double denominator = 1.0 / (va + vb + vc);
  return a + ab * (vb * denominator) + ac * (vc * denominator);
}

double squaredDistance(const Bvh::Child& child, const Vector3d& p) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double outside = std::max({child.low[i] - p[i], p[i] - child.high[i], 0.0});
    sum += outside * outside;
  }
  return sum;
}

/// Keeps the closest point seen so far and settles ties between triangles that share it.
class ClosestSoFar {
public:
  explicit ClosestSoFar(const Vector3d& p) : p_(p) { best_.squared_distance = infinity; }

  /// Subtrees beyond this distance cannot matter; ties can.
  double limit() const { return best_.squared_distance * (1.0 + tie); }
  const Bvh::Closest& best() const { return best_; }

  void consider(const Bvh::Triangle& triangle) {
    const Vector3d point = closestOnTriangle(p_, triangle.corners);
    const double distance = (p_ - point).squaredNorm();
    if (distance > limit()) return;
    const double facing = facingOf(triangle, point);
    const bool is_tie = distance >= best_.squared_distance * (1.0 - tie);
    if (is_tie && facing <= facing_) return;
    best_ = {point, distance, triangle.index};
    facing_ = facing;
  }

private:
  static constexpr double tie = 1e-12;

  /// How far p is in front of or behind the triangle's plane.
  double facingOf(const Bvh::Triangle& triangle, const Vector3d& point) const {
    const auto& [a, b, c] = triangle.corners;
    return std::abs((p_ - point).dot((b - a).cross(c - a).normalized()));
  }

  Vector3d p_;
  Bvh::Closest best_;
  double facing_ = -1.0;
};

}  // namespace

Bvh::Bvh(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InputError("mesh", "number of triangles", "0", "at least 1");
  BvhLayout layout = buildBvh(mesh);
  root_ = layout.root;
  nodes_ = std::move(layout.nodes);
  triangles_.reserve(layout.order.size());
  for (const std::uint32_t index : layout.order) {
    const auto& [a, b, c] = mesh.triangles[index];
    triangles_.push_back({{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, index});
  }
}

std::optional<Bvh::Hit> Bvh::castRay(const geometry::Ray& ray, double max_distance) const {
  const PreparedRay prepared(ray);
  std::optional<Hit> nearest;
  double limit = max_distance;
  const auto bound = [&](const Child& child) { return prepared.enter(child, limit); };
  Stack stack;
  if (bound(root_) < infinity) stack.push(root_, 0.0);
  while (!stack.isEmpty()) {
    const auto [child, entry] = stack.pop();
    if (entry > limit) continue;
    if (child->count == 0) {
      pushChildren(nodes_[child->first], bound, std::min(limit, std::numeric_limits<double>::max()), stack);
    }
    for (std::uint32_t i = child->first; i < child->first + child->count; ++i) {
      const double t = prepared.hit(triangles_[i]);
      if (!(t > 0.0 && t <= limit)) continue;
      if (nearest && t == limit && triangles_[i].index > nearest->triangle) continue;
      nearest = Hit{t, triangles_[i].index};
      limit = t;
    }
  }
  return nearest;
}

Bvh::Closest Bvh::closestPoint(const Vector3d& p) const {
  ClosestSoFar closest(p);
  const auto bound = [&p](const Child& child) { return squaredDistance(child, p); };
  Stack stack;
  stack.push(root_, bound(root_));
  while (!stack.isEmpty()) {
    const auto [child, distance] = stack.pop();
    if (distance > closest.limit()) continue;
    if (child->count == 0) pushChildren(nodes_[child->first], bound, closest.limit(), stack);
    for (std::uint32_t i = child->first; i < child->first + child->count; ++i) closest.consider(triangles_[i]);
  }
  return closest.best();
}

}  // namespace scan_to_path::mesh
