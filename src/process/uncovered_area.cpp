// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/uncovered_area.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/scan/outline.h"
#include "scan_to_path/toolpath/ball_tool.h"
#include "scan_to_path/toolpath/contact_frame.h"
#include "scan_to_path/toolpath/scan_surface.h"

namespace scan_to_path::process {
namespace {

using geometry::Vector3;

constexpr double most_points = 40000.0;
constexpr double finest_grid = 1e-4;  // [m]

/// Points `height` over the part's surface that no ball has been at yet, in columns over a grid in the scan plane.
class StandingPoints {
public:
  StandingPoints(const scan::FittedScan& scan, double height) {
    Eigen::AlignedBox2d extent;
    for (const auto& polygon : scan.outline.polygons) {
      for (const auto& corner : polygon) extent.extend(corner);
    }
    const Eigen::Vector2d size = extent.sizes();
    spacing_ = std::max(finest_grid, std::sqrt(size.x() * size.y() / most_points));
    origin_ = extent.min();
    count_x_ = static_cast<long>(std::ceil(size.x() / spacing_));
    count_y_ = static_cast<long>(std::ceil(size.y() / spacing_));
    points_.resize(static_cast<std::size_t>(count_x_ * count_y_));
    stands_.assign(points_.size(), 0);
    raise(scan, height);
  }

  double cell() const { return spacing_ * spacing_; }
  std::size_t all() const { return all_; }
  std::size_t standing() const { return static_cast<std::size_t>(std::count(stands_.begin(), stands_.end(), 1)); }

  /// Takes off what a ball meets whose centre moves from a to b.
  void cut(const Vector3& a, const Vector3& b, double radius) {
    const Vector3 along = b - a;
    const double squared_length = along.squaredNorm();
    const double squared_radius = radius * radius;
    const long first_x = index(std::min(a.x(), b.x()) - radius - origin_.x(), count_x_);
    const long last_x = index(std::max(a.x(), b.x()) + radius - origin_.x(), count_x_);
    const long first_y = index(std::min(a.y(), b.y()) - radius - origin_.y(), count_y_);
    const long last_y = index(std::max(a.y(), b.y()) + radius - origin_.y(), count_y_);
    for (long y = first_y; y <= last_y; ++y) {
      for (long x = first_x; x <= last_x; ++x) {
        const auto i = static_cast<std::size_t>(y * count_x_ + x);
        if (stands_[i] == 0) continue;
        const Vector3 off = points_[i] - a;
        const double share = squared_length > 0.0 ? std::clamp(off.dot(along) / squared_length, 0.0, 1.0) : 0.0;
        if ((off - share * along).squaredNorm() <= squared_radius) stands_[i] = 0;
      }
    }
  }

private:
  long index(double offset, long count) const {
    return static_cast<long>(std::clamp(std::floor(offset / spacing_), 0.0, static_cast<double>(count - 1)));
  }

  void raise(const scan::FittedScan& scan, double height) {
    const scan::OutlineTest part(scan.outline);
    const toolpath::ScanSurface surface(scan.surface);
    for (long y = 0; y < count_y_; ++y) {
      for (long x = 0; x < count_x_; ++x) {
        const Eigen::Vector2d at =
            origin_ + spacing_ * Eigen::Vector2d(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
        if (!part.inside(at.x(), at.y())) continue;
        const auto jet = surface.jet(at.x(), at.y());
        const auto i = static_cast<std::size_t>(y * count_x_ + x);
        points_[i] = Vector3(at.x(), at.y(), jet.z) + height * toolpath::normalOf(jet);
        stands_[i] = 1;
        ++all_;
      }
    }
  }

  double spacing_ = 0.0;
  Eigen::Vector2d origin_;
  long count_x_ = 0;
  long count_y_ = 0;
  std::size_t all_ = 0;
  std::vector<Vector3> points_;
  std::vector<char> stands_;
};

}  // namespace

UncoveredArea uncoveredArea(const toolpath::ToolPath& path, const std::vector<double>& allowances,
                            const scan::FittedScan& scan, double ball_radius, double height) {
  StandingPoints points(scan, height);
  const scan::Frame T_scan_cloud = scan.T_cloud_scan.inverse();
  const auto centre = [&](const toolpath::Waypoint& waypoint) -> Vector3 {
    return T_scan_cloud * toolpath::ballCentre(waypoint.pose, ball_radius);
  };
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    if (!allowances.empty() && allowances[s] > 0.0) continue;
    const auto& waypoints = path.segments[s].waypoints;
    for (std::size_t i = 1; i < waypoints.size(); ++i) {
      if (waypoints[i].process_on) points.cut(centre(waypoints[i - 1]), centre(waypoints[i]), ball_radius);
    }
  }
  UncoveredArea uncovered;
  if (points.all() == 0) return uncovered;
  uncovered.area = static_cast<double>(points.standing()) * points.cell();
  uncovered.share = static_cast<double>(points.standing()) / static_cast<double>(points.all());
  return uncovered;
}

}  // namespace scan_to_path::process
