// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/gouge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/toolpath/ball_tool.h"
#include "scan_to_path/toolpath/contact_frame.h"
#include "scan_to_path/toolpath/outline_clip.h"
#include "solid_points.h"

namespace scan_to_path::toolpath {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();
constexpr double cells_per_radius = 16.0;
constexpr std::size_t block_side = 4;     // nodes
constexpr double most_nodes = 5e7;        // 400 MB
constexpr double line_spacing = 0.25;     // cells: half of it beside the deepest point is 1 um of a ball of 20 mm
constexpr double own_surroundings = 2.0;  // cells around the contact, where the ball rests on the surface

std::string millimetres(double metres) { return fixed(1e3 * metres, 3) + " mm"; }

double square(double x) { return x * x; }

/// Distance from x to the range [low, high].
double outside(double x, double low, double high) { return std::max({low - x, x - high, 0.0}); }

}  // namespace

GougeCheck::GougeCheck(const scan::FittedScan& scan, double ball_radius, double tolerance, GougeTarget target)
    : scan_(scan),
      T_scan_cloud_(scan.T_cloud_scan.inverse()),
      surface_(scan.surface),
      radius_(ball_radius),
      tolerance_(tolerance) {
  if (!(radius_ > 0.0) || !std::isfinite(radius_)) {
    throw InputError("gouge check", "ball radius", fixed(radius_, 6) + " m", "positive");
  }
  if (!(tolerance_ >= 0.0)) throw InputError("gouge check", "tolerance", fixed(tolerance_, 9) + " m", "0 or more");
  spacing_ = radius_ / cells_per_radius;
  sampleHeights();
  findTops();
  const double side = static_cast<double>(block_side) * spacing_;
  if (target == GougeTarget::surface_and_lines) {
    lines_ = std::make_unique<const SolidPoints>(pointsOnLines(scan, line_spacing * spacing_), side);
  }
  std::vector<Vector3> obstacles;
  for (const auto& point : scan.obstacles) obstacles.push_back(point.cast<double>());
  obstacles_ = std::make_unique<const SolidPoints>(obstacles, side);
}

GougeCheck::~GougeCheck() = default;

void GougeCheck::sampleHeights() {
  const OutlineClip clip(scan_.outline, 0.0, 0.0);
  origin_ = {clip.firstT(), clip.first()};
  const double nodes_x = std::floor((clip.lastT() - clip.firstT()) / spacing_) + 1.0;
  const double nodes_y = std::floor((clip.last() - clip.first()) / spacing_) + 1.0;
  if (!(nodes_x * nodes_y <= most_nodes)) {
    throw InputError("gouge check", "ball radius", millimetres(radius_), "larger for a part of this extent");
  }
  count_x_ = static_cast<std::size_t>(nodes_x);
  count_y_ = static_cast<std::size_t>(nodes_y);
  heights_.assign(count_x_ * count_y_, nothing);
  for (std::size_t j = 0; j < count_y_; ++j) {
    const double y = origin_.y() + static_cast<double>(j) * spacing_;
    for (const Interval& interval : clip.inside(y)) {
      const auto begin = static_cast<std::size_t>(std::ceil(std::max(0.0, (interval.begin - origin_.x()) / spacing_)));
      for (std::size_t i = begin; i < count_x_; ++i) {
        const double x = origin_.x() + static_cast<double>(i) * spacing_;
        if (x > interval.end) break;
        heights_[j * count_x_ + i] = surface_.height(x, y);
      }
    }
  }
}

void GougeCheck::findTops() {
  blocks_x_ = (count_x_ + block_side - 1) / block_side;
  blocks_y_ = (count_y_ + block_side - 1) / block_side;
  tops_.assign(blocks_x_ * blocks_y_, nothing);
  for (std::size_t j = 0; j < count_y_; ++j) {
    for (std::size_t i = 0; i < count_x_; ++i) {
      double& top = tops_[j / block_side * blocks_x_ + i / block_side];
      top = std::max(top, heights_[j * count_x_ + i]);
    }
  }
}

std::optional<GougeCheck::Nearest> GougeCheck::nearestNode(const Vector3& centre, double reach,
                                                           const Vector3* contact) const {
  std::optional<Nearest> nearest;
  const double side = spacing_ * static_cast<double>(block_side);
  const auto first = [&](double offset) {
    return static_cast<std::size_t>(std::max(0.0, std::floor((offset - reach) / side)));
  };
  const double x = centre.x() - origin_.x();
  const double y = centre.y() - origin_.y();
  for (std::size_t by = first(y); by < blocks_y_ && static_cast<double>(by) * side <= y + reach; ++by) {
    for (std::size_t bx = first(x); bx < blocks_x_ && static_cast<double>(bx) * side <= x + reach; ++bx) {
      const double low_x = static_cast<double>(bx) * side;
      const double low_y = static_cast<double>(by) * side;
      const double distance2 = square(outside(x, low_x, low_x + side)) + square(outside(y, low_y, low_y + side)) +
                               square(std::max(0.0, centre.z() - tops_[by * blocks_x_ + bx]));
      if (distance2 < reach * reach) searchBlock(bx, by, centre, reach, contact, nearest);
    }
  }
  return nearest;
}

void GougeCheck::searchBlock(std::size_t block_x, std::size_t block_y, const Vector3& centre, double reach,
                             const Vector3* contact, std::optional<Nearest>& nearest) const {
  const double own = square(own_surroundings * spacing_);
  double least = square(nearest ? nearest->distance : reach);
  const std::size_t end_x = std::min(count_x_, (block_x + 1) * block_side);
  const std::size_t end_y = std::min(count_y_, (block_y + 1) * block_side);
  for (std::size_t j = block_y * block_side; j < end_y; ++j) {
    const double y = origin_.y() + static_cast<double>(j) * spacing_;
    for (std::size_t i = block_x * block_side; i < end_x; ++i) {
      const double x = origin_.x() + static_cast<double>(i) * spacing_;
      const double z = heights_[j * count_x_ + i];
      const double distance2 = square(x - centre.x()) + square(y - centre.y()) + square(z - centre.z());
      if (!(distance2 < least)) continue;
      // Around its contact the ball rests on the surface, a hair outside the nodes: only a node in the ball counts.
      const bool is_own = contact != nullptr && square(x - contact->x()) + square(y - contact->y()) < own;
      if (is_own && distance2 >= square(reach - spacing_ * spacing_ / radius_)) continue;
      least = distance2;
      nearest = Nearest{std::sqrt(distance2), {x, y, z}};
    }
  }
}

/// Newton's method on the squared distance from the centre to the graph, from the nearest node.
GougeCheck::Nearest GougeCheck::refined(const Vector3& centre, const Nearest& start) const {
  Nearest nearest = start;
  Eigen::Vector2d xy = start.point.head<2>();
  for (int i = 0; i < 10; ++i) {
    const HeightJet jet = surface_.jet(xy.x(), xy.y());
    const Eigen::Vector2d slope(jet.zx, jet.zy);
    const double rise = jet.z - centre.z();
    Eigen::Matrix2d bend;
    bend << jet.zxx, jet.zxy, jet.zxy, jet.zyy;
    const Eigen::Vector2d gradient = xy - centre.head<2>() + rise * slope;
    const Eigen::Matrix2d hessian = Eigen::Matrix2d::Identity() + slope * slope.transpose() + rise * bend;
    if (!(hessian.determinant() > 0.0 && hessian.trace() > 0.0)) break;
    Eigen::Vector2d step = -hessian.inverse() * gradient;
    if (step.norm() > spacing_) step *= spacing_ / step.norm();
    xy += step;
    if ((xy - start.point.head<2>()).norm() > 2.0 * spacing_) break;
    const Vector3 point(xy.x(), xy.y(), surface_.height(xy.x(), xy.y()));
    const double distance = (point - centre).norm();
    if (distance < nearest.distance) nearest = {distance, point};
    if (step.norm() < 1e-9) break;
  }
  return nearest;
}

/// The point that is deepest in a ball; nothing when none is in it.
std::optional<GougeCheck::Deepest> GougeCheck::deepest(const Vector3& centre, double radius,
                                                       const Vector3* contact) const {
  std::optional<Deepest> found;
  double least = radius;
  const auto take = [&](const std::optional<Vector3>& point, bool is_part) {
    if (!point) return;
    found = Deepest{*point, is_part};
    least = std::min(least, (*point - centre).norm());
  };
  const double slack = spacing_ * spacing_ / radius_;
  if (const auto node = nearestNode(centre, radius + slack, contact)) take(refined(centre, *node).point, true);
  if (lines_ != nullptr) take(lines_->nearest(centre, least), true);
  take(obstacles_->nearest(centre, least), false);
  return found;
}

bool GougeCheck::entersAt(const Vector3& centre, double radius, double tolerance, const Vector3* contact,
                          WaypointVerdict& verdict) const {
  const auto found = deepest(centre, radius, contact);
  if (!found || (found->point - centre).norm() >= radius - tolerance) return false;
  const Vector3 place = scan_.T_cloud_scan * found->point;
  verdict.margin = (found->point - centre).norm() - radius;
  verdict.reason = "the ball goes " + millimetres(-verdict.margin) +
                   (found->is_part ? " into the surface at (" : " into what stands there beside the fit at (") +
                   fixed(place.x(), 4) + ", " + fixed(place.y(), 4) + ", " + fixed(place.z(), 4) + ")";
  verdict.remedy = found->is_part ? "use a smaller ball, or keep the rows off this place"
                                  : "take it away and scan again, or keep rows and links off this place";
  return true;
}

/// Sweeps the ball along a straight move, its ends left out, and tells where it is deepest. Where it is on the surface
/// at both ends, it is all the way.
bool GougeCheck::judgeMove(const Waypoint& from, const Waypoint& to, double allowance, double tolerance,
                           bool on_surface, WaypointVerdict& verdict) const {
  const Frame T_from = T_scan_cloud_ * from.pose;
  const Frame T_to = T_scan_cloud_ * to.pose;
  const double radius = radius_ + allowance;
  const Vector3 begin = ballCentre(T_from, radius_);
  const Vector3 end = ballCentre(T_to, radius_);
  const int steps = static_cast<int>(std::ceil((end - begin).norm() / spacing_));
  std::optional<WaypointVerdict> worst;
  for (int i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Vector3 centre = begin + share * (end - begin);
    const Vector3 normal = (1.0 - share) * T_from.linear().col(2) + share * T_to.linear().col(2);
    const Vector3 contact = centre - radius * normal.normalized();
    WaypointVerdict here = verdict;
    if (!entersAt(centre, radius, tolerance, on_surface ? &contact : nullptr, here)) continue;
    if (!worst || here.margin < worst->margin) worst = std::move(here);
  }
  if (!worst) return false;
  verdict = std::move(*worst);
  verdict.reason = "on the move to it " + verdict.reason;
  return true;
}

bool GougeCheck::judgeWaypoint(const Segment& segment, std::size_t index, double allowance,
                               WaypointVerdict& verdict) const {
  const Frame T_scan_contact = T_scan_cloud_ * segment.waypoints[index].pose;
  const double radius = radius_ + allowance;
  const Vector3 centre = ballCentre(T_scan_contact, radius_);
  const bool touches = isContact(segment, index);
  const Vector3 contact = centre - radius * T_scan_contact.linear().col(2);
  if (touches) {
    const double curvature = smallestCurvature(surface_.jet(contact.x(), contact.y()));
    if (curvature * radius <= -1.0) {
      verdict.margin = -1.0 / curvature - radius;
      verdict.reason = "the surface is hollow with a radius of " + millimetres(-1.0 / curvature) + ", the ball has " +
                       millimetres(radius);
      verdict.remedy = "use a ball smaller than " + millimetres(-1.0 / curvature - allowance);
      return true;
    }
  }
  return entersAt(centre, radius, tolerance_, touches ? &contact : nullptr, verdict);
}

std::vector<WaypointVerdict> GougeCheck::check(const ToolPath& path, const std::vector<double>& allowance,
                                               double chord_tolerance, const Progress& progress) const {
  if (!allowance.empty() && allowance.size() != path.segments.size()) {
    throw InputError("gouge check", "number of allowances", std::to_string(allowance.size()),
                     "one for each of the " + std::to_string(path.segments.size()) + " segments");
  }
  std::vector<WaypointVerdict> gouges;
  const Waypoint* before = nullptr;
  bool touched = false;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    progress.checkCancelled();
    for (std::size_t i = 0; i < path.segments[s].waypoints.size(); ++i) {
      WaypointVerdict verdict;
      verdict.segment = static_cast<int>(s);
      verdict.index = static_cast<int>(i);
      verdict.verdict = Verdict::gouge;
      verdict.unit = "m";
      const double left = allowance.empty() ? 0.0 : allowance[s];
      const Waypoint& waypoint = path.segments[s].waypoints[i];
      const bool touches = isContact(path.segments[s], i);
      const bool on_surface = touched && touches;
      const double tolerance = tolerance_ + (on_surface ? chord_tolerance : 0.0);
      if (judgeWaypoint(path.segments[s], i, left, verdict) ||
          (before != nullptr && judgeMove(*before, waypoint, left, tolerance, on_surface, verdict))) {
        gouges.push_back(std::move(verdict));
      }
      before = &waypoint;
      touched = touches;
    }
  }
  return gouges;
}

}  // namespace scan_to_path::toolpath
