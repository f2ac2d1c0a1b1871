// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::toolpath {

using geometry::Vector3;

/// Points on a scan's fitted lines, sorted into square blocks seen along the scan frame's z.
class LinePoints {
public:
  /// Points at most `spacing` [m] apart along each line; blocks of sixteen spacings.
  LinePoints(const scan::FittedScan& scan, double spacing);

  /// The point nearest to `centre` among those nearer than `reach` [m]; both in the scan frame.
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

}  // namespace scan_to_path::toolpath
