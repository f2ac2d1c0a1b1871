// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::process {

using geometry::Vector3;

/// A point of a row in the scan frame.
struct RowPoint {
  double t = 0.0;                      ///< along the row in the scan plane [m]
  Vector3 point = Vector3::Zero();     ///< [m]
  Vector3 normal = Vector3::UnitZ();   ///< unit, outward
  Vector3 tangent = Vector3::UnitX();  ///< unit, towards rising t
};

/// A stretch of a row without interruption; points in rising t.
struct Row {
  int row = 0;
  int piece = 0;   ///< of the row, in rising t
  int pieces = 1;  ///< that the row has
  std::vector<RowPoint> points;
};

/// The rows of a path before they are driven: order across, then along.
struct RowPlan {
  std::vector<Row> rows;
  int last_row = 0;               ///< number of the whole part's last row, driven or not
  std::vector<double> distances;  ///< of neighbouring rows' planes [m]; none over rows that are left out
  double widest_scallop = 0.0;    ///< left between these neighbours on the fitted surface [m]
};

}  // namespace scan_to_path::process
