// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "solid_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scan_to_path/nurbs/curve.h"

namespace scan_to_path::toolpath {
namespace {

/// Points at equal steps of the parameter: the control polygon is no shorter than the curve.
void addPoints(const scan::FittedLine& line, const scan::Frame& T_scan_cloud, double spacing,
               std::vector<Vector3>& points) {
  const auto& control_points = line.curve.control_points;
  double length = 0.0;
  for (std::size_t i = 1; i < control_points.size(); ++i) length += (control_points[i] - control_points[i - 1]).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing)));
  for (int i = 0; i <= steps; ++i) {
    const double u = line.begin + (line.end - line.begin) * i / steps;
    points.push_back(T_scan_cloud * nurbs::pointAt(line.curve, u));
  }
}

}  // namespace

SolidPoints::SolidPoints(const std::vector<Vector3>& points, double side) : side_(side) {
  for (const auto& point : points) area_.extend(point.head<2>());
  sortIntoBlocks(points);
}

std::size_t SolidPoints::column(double x) const {
  return static_cast<std::size_t>(std::max(0.0, std::floor((x - area_.min().x()) / side_)));
}

std::size_t SolidPoints::line(double y) const {
  return static_cast<std::size_t>(std::max(0.0, std::floor((y - area_.min().y()) / side_)));
}

/// By counting: every point goes to its block at once.
void SolidPoints::sortIntoBlocks(const std::vector<Vector3>& points) {
  if (points.empty()) return;
  columns_ = column(area_.max().x()) + 1;
  const std::size_t blocks = columns_ * (line(area_.max().y()) + 1);
  const auto blockOf = [this](const Vector3& p) { return line(p.y()) * columns_ + column(p.x()); };
  first_.assign(blocks + 1, 0);
  tops_.assign(blocks, -std::numeric_limits<double>::infinity());
  for (const auto& point : points) {
    ++first_[blockOf(point) + 1];
    tops_[blockOf(point)] = std::max(tops_[blockOf(point)], point.z());
  }
  for (std::size_t b = 0; b < blocks; ++b) first_[b + 1] += first_[b];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  points_.resize(points.size());
  for (const auto& point : points) points_[next[blockOf(point)]++] = point;
}

std::optional<Vector3> SolidPoints::nearest(const Vector3& centre, double reach) const {
  std::optional<Vector3> found;
  double least = reach * reach;
  if (points_.empty() || area_.squaredExteriorDistance(centre.head<2>()) >= least) return found;
  const std::size_t last_column = std::min(columns_ - 1, column(centre.x() + reach));
  const std::size_t last_line = std::min(tops_.size() / columns_ - 1, line(centre.y() + reach));
  for (std::size_t y = line(centre.y() - reach); y <= last_line; ++y) {
    for (std::size_t x = column(centre.x() - reach); x <= last_column; ++x) {
      const std::size_t block = y * columns_ + x;
      const double above = std::max(0.0, centre.z() - tops_[block]);
      if (above * above >= least) continue;
      for (std::size_t i = first_[block]; i < first_[block + 1]; ++i) {
        const Vector3 place(points_[i].x(), points_[i].y(), std::min(points_[i].z(), centre.z()));
        const double distance2 = (place - centre).squaredNorm();
        if (distance2 >= least) continue;
        least = distance2;
        found = place;
      }
    }
  }
  return found;
}

std::vector<Vector3> pointsOnLines(const scan::FittedScan& scan, double spacing) {
  const scan::Frame T_scan_cloud = scan.T_cloud_scan.inverse();
  std::vector<Vector3> points;
  for (const auto& line : scan.lines) addPoints(line, T_scan_cloud, spacing, points);
  return points;
}

}  // namespace scan_to_path::toolpath
