// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/outline_clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scan_to_path/common/error.h"

namespace scan_to_path::toolpath {
namespace {

using Eigen::Vector2d;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool crosses(double a, double b) { return (a < 0.0) != (b < 0.0); }

/// t where the line from a to b meets s = 0; precondition: it crosses.
double crossing(const Vector2d& a, const Vector2d& b) { return a.x() - a.y() * (b.x() - a.x()) / (b.y() - a.y()); }

void extend(Interval& interval, double t) {
  interval.begin = std::min(interval.begin, t);
  interval.end = std::max(interval.end, t);
}

/// Where the line s = 0 is nearer than `margin` to the edge: the hull of what its two end discs and its strip cut out.
Interval nearEdge(const Vector2d& a, const Vector2d& b, double margin) {
  Interval near = {infinity, -infinity};
  for (const Vector2d& end : {a, b}) {
    if (std::abs(end.y()) >= margin) continue;
    const double half = std::sqrt(margin * margin - end.y() * end.y());
    extend(near, end.x() - half);
    extend(near, end.x() + half);
  }
  const double length = (b - a).norm();
  if (length > 0.0) {
    const Vector2d side = Vector2d(a.y() - b.y(), b.x() - a.x()) * (margin / length);
    const std::array<Vector2d, 4> corners = {a + side, b + side, b - side, a - side};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2d& next = corners[(i + 1) % corners.size()];
      if (crosses(corners[i].y(), next.y())) extend(near, crossing(corners[i], next));
    }
  }
  return near;
}

/// `from` without `cuts`; both sorted by begin, cuts may overlap.
std::vector<Interval> difference(const std::vector<Interval>& from, const std::vector<Interval>& cuts) {
  std::vector<Interval> left;
  for (Interval rest : from) {
    for (const Interval& cut : cuts) {
      if (cut.end <= rest.begin) continue;
      if (cut.begin >= rest.end) break;
      if (cut.begin > rest.begin) left.push_back({rest.begin, cut.begin});
      rest.begin = cut.end;
      if (rest.begin >= rest.end) break;
    }
    if (rest.begin < rest.end) left.push_back(rest);
  }
  return left;
}

}  // namespace

OutlineClip::OutlineClip(const scan::Outline& outline, double direction, double margin)
    : margin_(margin), s_min_(infinity), s_max_(-infinity), t_min_(infinity), t_max_(-infinity) {
  const Vector2d along(std::cos(direction), std::sin(direction));
  const Vector2d across(-along.y(), along.x());
  for (const auto& polygon : outline.polygons) {
    if (polygon.size() < 3) throw InputError("outline: a polygon has fewer than three points");
    std::vector<Vector2d> turned;
    for (const auto& point : polygon) {
      if (!point.allFinite()) throw InputError("outline: a point is not finite");
      turned.emplace_back(point.dot(along), point.dot(across));
      t_min_ = std::min(t_min_, turned.back().x());
      t_max_ = std::max(t_max_, turned.back().x());
      s_min_ = std::min(s_min_, turned.back().y());
      s_max_ = std::max(s_max_, turned.back().y());
    }
    for (std::size_t i = 0; i < turned.size(); ++i) edges_.push_back({turned[i], turned[(i + 1) % turned.size()]});
  }
  if (edges_.empty()) throw InputError("outline: has no polygon, the part's extent is not known");
}

std::vector<Interval> OutlineClip::inside(double s) const {
  const Vector2d shift(0.0, s);
  std::vector<double> crossings;
  std::vector<Interval> near_edges;
  for (const Edge& edge : edges_) {
    const Vector2d a = edge.a - shift;
    const Vector2d b = edge.b - shift;
    if (std::min(a.y(), b.y()) > margin_ || std::max(a.y(), b.y()) < -margin_) continue;
    if (crosses(a.y(), b.y())) crossings.push_back(crossing(a, b));
    if (margin_ <= 0.0) continue;
    const Interval near = nearEdge(a, b, margin_);
    if (near.begin < near.end) near_edges.push_back(near);
  }
  std::sort(crossings.begin(), crossings.end());
  std::sort(near_edges.begin(), near_edges.end(),
            [](const Interval& a, const Interval& b) { return a.begin < b.begin; });
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i] < crossings[i + 1]) intervals.push_back({crossings[i], crossings[i + 1]});
  }
  return difference(intervals, near_edges);
}

}  // namespace scan_to_path::toolpath
