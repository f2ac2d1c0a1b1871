// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/obstacles.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace scan_to_path::scan {

Obstacles highestPoints(const Obstacles& points, double side) {
  const auto square = [side](const Eigen::Vector3f& p) {
    return std::pair(std::floor(p.y() / side), std::floor(p.x() / side));
  };
  Obstacles sorted = points;
  std::sort(sorted.begin(), sorted.end(), [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return std::tuple(square(a), -a.z(), a.y(), a.x()) < std::tuple(square(b), -b.z(), b.y(), b.x());
  });
  const auto same_square = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return square(a) == square(b); };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same_square), sorted.end());
  return sorted;
}

}  // namespace scan_to_path::scan
