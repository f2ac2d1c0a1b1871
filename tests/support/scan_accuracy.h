// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::test {

/// Mean, largest and root mean square of what was added.
struct Statistic {
  double sum = 0.0;
  double squares = 0.0;
  double largest = 0.0;
  std::size_t count = 0;

  void add(double value) {
    sum += std::abs(value);
    squares += value * value;
    largest = std::max(largest, std::abs(value));
    ++count;
  }
  double mean() const { return sum / static_cast<double>(count); }
  double rms() const { return std::sqrt(squares / static_cast<double>(count)); }
};

/// How far oriented points are from a height field, measured in its own frame.
struct ScanAccuracy {
  Statistic inside;    ///< angle of the normals off the truth [deg], inner rows but for their ends
  Statistic border;    ///< …, first and last row and the first and last millimetres of the others
  Statistic all;       ///< …, everywhere
  Statistic distance;  ///< of the points, along the true normal [m]
};

inline ScanAccuracy measureAccuracy(const std::vector<scan::OrientedLine>& lines, const scan::FittedScan& scan,
                                    const geometry::HeightField& truth,
                                    const geometry::Frame& T_cloud_truth = geometry::Frame::Identity()) {
  constexpr double degrees = 57.29577951308232;
  constexpr double end_zone = 0.002;  // [m]
  const geometry::Frame T_truth_cloud = T_cloud_truth.inverse();
  const int last_row = scan.lines.back().row;
  ScanAccuracy accuracy;
  for (const scan::OrientedLine& line : lines) {
    const int row = scan.lines[static_cast<std::size_t>(line.line)].row;
    const geometry::Vector3 first = line.points.front().point;
    const geometry::Vector3 last = line.points.back().point;
    for (const scan::OrientedPoint& point : line.points) {
      const geometry::Vector3 p = T_truth_cloud * point.point;
      const geometry::HeightJet jet = truth.jet(p.x(), p.y());
      const geometry::Vector3 normal = geometry::Vector3(-jet.zx, -jet.zy, 1.0).normalized();
      const double angle = degrees * geometry::angleBetween(T_truth_cloud.linear() * point.normal, normal);
      const bool at_end = (point.point - first).norm() < end_zone || (point.point - last).norm() < end_zone;
      (row == 0 || row == last_row || at_end ? accuracy.border : accuracy.inside).add(angle);
      accuracy.all.add(angle);
      accuracy.distance.add((p.z() - jet.z) * normal.z());  // to first order in the distance
    }
  }
  return accuracy;
}

}  // namespace scan_to_path::test
