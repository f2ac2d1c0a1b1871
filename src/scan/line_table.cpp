// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "line_table.h"

#include <algorithm>

#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::scan {

LineTable::LineTable(const FittedLine& line, const Frame& T_scan_cloud) : begin_(line.begin), end_(line.end) {
  const nurbs::Curve& curve = line.curve;
  if (curve.degree != 3 || !curve.weights.empty()) {
    throw InputError("fitted line", "curve", "rational or of degree " + std::to_string(curve.degree),
                     "a cubic B-spline");
  }
  std::vector<Vector3> points;
  points.reserve(curve.control_points.size());
  for (const Vector3& p : curve.control_points) points.push_back(T_scan_cloud * p);
  const std::vector<double>& t = curve.knots;
  for (std::size_t i = 3; i + 4 < t.size(); ++i) {
    if (!(t[i] < t[i + 1])) continue;
    const nurbs::CubicSpanMatrix basis = nurbs::cubicSpanMatrix(&t[i - 2]);
    Span span;
    span.centre = 0.5 * (t[i] + t[i + 1]);
    span.scale = 2.0 / (t[i + 1] - t[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      span.c[k].setZero();
      for (std::size_t j = 0; j < 4; ++j) span.c[k] += basis[k][j] * points[i - 3 + j];
    }
    spans_.push_back(span);
    breaks_.push_back(t[i]);
  }
  if (spans_.empty()) throw InputError("fitted line", "number of knot spans", "0", "at least 1");
  breaks_.push_back(curve.last());
  std::size_t hint = 0;
  x_begin_ = point(begin_, hint).x();
  x_end_ = point(end_, hint).x();
}

ScanTables makeTables(const FittedScan& scan) {
  ScanTables tables;
  tables.T_scan_cloud = scan.T_cloud_scan.inverse();
  tables.lines.reserve(scan.lines.size());
  for (const FittedLine& line : scan.lines) {
    const auto row = static_cast<std::size_t>(std::max(line.row, 0));
    while (tables.row_first.size() < row + 1) {
      tables.row_first.push_back(tables.lines.size());
      tables.row_forward.push_back(1);
    }
    tables.row_forward[row] = line.forward ? 1 : 0;
    tables.lines.emplace_back(line, tables.T_scan_cloud);
  }
  tables.row_first.push_back(tables.lines.size());
  return tables;
}

}  // namespace scan_to_path::scan
