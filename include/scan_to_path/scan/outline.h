// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::scan {

/// The part's boundary (spec cutting, step 6): first and last sample of every piece, joined from row to row where
/// pieces of neighbouring rows overlap along x. Between two rows only what lies between overlapping pieces counts as
/// part, so a hole reaches to the rows around it: conservative. Ends further apart than twice the rows' distance are
/// cut down to the overlap: what lies beside it only one row has seen. Polygons as Outline has them.
Outline traceOutline(const SampleRows& rows);

/// Tells whether points lie on the part, in O(1) for a raster's outline: edges are kept in bins over y.
class OutlineTest {
public:
  explicit OutlineTest(const Outline& outline);

  /// x, y in the scan frame [m]. Points on the boundary count as inside on its lower and left edges only.
  bool inside(double x, double y) const;

private:
  struct Edge {
    double y_low;
    double y_high;
    double x_at_low;
    double dx_dy;
  };
  double y_min_ = 0.0;
  double bins_per_metre_ = 0.0;
  std::vector<std::size_t> first_;  ///< of each bin's edges; one more entry than bins
  std::vector<Edge> edges_;
};

}  // namespace scan_to_path::scan
