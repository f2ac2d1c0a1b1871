// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::scan {

/// A fitted line as one cubic polynomial per knot span, in scan-frame coordinates: a few multiplications per point
/// when parameters come in order. Spans are looked for from where the last search ended (`hint`), so a sweep along
/// the line costs O(1) per point.
class LineTable {
public:
  LineTable(const FittedLine& line, const Frame& T_scan_cloud);

  double begin() const { return begin_; }
  double end() const { return end_; }
  double xBegin() const { return x_begin_; }
  double xEnd() const { return x_end_; }

  struct Jet {
    Vector3 point;
    Vector3 first;
    Vector3 second;
  };
  Vector3 point(double u, std::size_t& hint) const;
  Jet jet(double u, std::size_t& hint) const;

  /// The point where the line passes x; it runs towards +x. `u`: a first guess, then the point's parameter.
  Vector3 pointAtX(double x, double& u, std::size_t& hint) const;

  const std::vector<double>& breaks() const { return breaks_; }

private:
  struct Span {
    double centre = 0.0;
    double scale = 0.0;  ///< 2 / width
    Vector3 c[4];        ///< coefficients of s^k, s = (u - centre) * scale
  };
  const Span& find(double u, std::size_t& hint) const;

  std::vector<Span> spans_;
  std::vector<double> breaks_;  ///< one more than spans
  double begin_ = 0.0;
  double end_ = 0.0;
  double x_begin_ = 0.0;
  double x_end_ = 0.0;
};

inline const LineTable::Span& LineTable::find(double u, std::size_t& hint) const {
  while (hint > 0 && u < breaks_[hint]) --hint;
  while (hint + 1 < spans_.size() && u >= breaks_[hint + 1]) ++hint;
  return spans_[hint];
}

inline Vector3 LineTable::point(double u, std::size_t& hint) const {
  const Span& span = find(u, hint);
  const double s = (u - span.centre) * span.scale;
  return span.c[0] + s * (span.c[1] + s * (span.c[2] + s * span.c[3]));
}

inline LineTable::Jet LineTable::jet(double u, std::size_t& hint) const {
  const Span& span = find(u, hint);
  const double s = (u - span.centre) * span.scale;
  return {span.c[0] + s * (span.c[1] + s * (span.c[2] + s * span.c[3])),
          span.scale * (span.c[1] + s * (2.0 * span.c[2] + 3.0 * s * span.c[3])),
          span.scale * span.scale * (2.0 * span.c[2] + 6.0 * s * span.c[3])};
}

inline Vector3 LineTable::pointAtX(double x, double& u, std::size_t& hint) const {
  constexpr double exact_enough = 1e-9;  // [m]: a nanometre along the line moves no normal
  constexpr int most_steps = 20;
  for (int step = 0;; ++step) {
    const Span& span = find(u, hint);
    const double s = (u - span.centre) * span.scale;
    const Vector3 point = span.c[0] + s * (span.c[1] + s * (span.c[2] + s * span.c[3]));
    const double off = point.x() - x;
    if ((off < exact_enough && off > -exact_enough) || step == most_steps) return point;
    const double slope = span.scale * (span.c[1].x() + s * (2.0 * span.c[2].x() + 3.0 * s * span.c[3].x()));
    if (!(slope > 0.0)) return point;
    u -= off / slope;
  }
}

/// The tables of all lines and which of them make up each row.
struct ScanTables {
  Frame T_scan_cloud = Frame::Identity();
  std::vector<LineTable> lines;
  std::vector<std::size_t> row_first;  ///< first line of row r; one more entry than rows
  std::vector<char> row_forward;

  int rowCount() const { return static_cast<int>(row_first.size()) - 1; }
};

ScanTables makeTables(const FittedScan& scan);

}  // namespace scan_to_path::scan
