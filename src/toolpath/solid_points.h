// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::toolpath {

using geometry::Vector3;

/// Points in the scan frame with material from each of them down, sorted into square blocks seen along z.
class SolidPoints {
public:
  /// Blocks of `side` [m].
  SolidPoints(const std::vector<Vector3>& points, double side);

  /// The place of the material below the points that is nearest to `centre` among those nearer than `reach` [m].
  std::optional<Vector3> nearest(const Vector3& centre, double reach) const;

private:
  std::size_t column(double x) const;
  std::size_t line(double y) const;
  void sortIntoBlocks(const std::vector<Vector3>& points);

  double side_;
  Eigen::AlignedBox2d area_;
  std::size_t columns_ = 0;
  std::vector<std::size_t> first_;  ///< of each block's points, and the end of the last one's
  std::vector<Vector3> points_;
  std::vector<double> tops_;  ///< z of each block's highest point
};

/// Points at most `spacing` [m] apart along the scan's fitted lines, in the scan frame.
std::vector<Vector3> pointsOnLines(const scan::FittedScan& scan, double spacing);

}  // namespace scan_to_path::toolpath
