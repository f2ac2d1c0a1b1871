// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/scan/resample.h"

namespace scan_to_path::scan {

enum class NormalMode {
  weighted,  ///< tangent of the fitted line times a second-order difference across the rows
  seed,      ///< area-weighted mean of the four triangles around the point (eqs. 8-10)
  surface,   ///< of the surface fitted through all lines
};

/// Points with normals on all lines, and how many points had to be left out.
struct OrientedScan {
  std::vector<OrientedLine> lines;  ///< one per fitted line that has points, in the scan's order
  std::vector<Dropped> dropped;     ///< "no neighbouring row": such a point has no honest normal
};

/// Normals of points on the fitted lines from the scan-line structure (spec cutting, steps 9 and 10). Neighbours are
/// the rows next to a point's own that pass its x without a break in between; rows beside a step or a roof edge along
/// the rows count only on the smoother side. Unit, on the sensor's side, in the cloud's frame.
///
/// weighted: the derivative across is sum w_k z_k / sum w_k y_k over up to five rows at the same x, with sum w = 0,
/// sum w s = 1, sum w s^2 = 0 (second order at any pitch, on the border too) and sum w d = 0, d = +-1 the rows'
/// travel direction: what a clock offset shifts every other row by cancels. With fewer rows conditions fall away from
/// the last one on; two rows give a plain difference.
///
/// Keeps no reference to the scan. const functions may be called from several threads.
class NormalEstimator {
public:
  /// Throws InputError when mode is surface and the scan has none, or a line is not a cubic B-spline.
  NormalEstimator(const FittedScan& scan, NormalMode mode);
  ~NormalEstimator();
  NormalEstimator(NormalEstimator&&) noexcept;

  /// The points at rising parameters of line number `line`; points without a neighbouring row are left out.
  OrientedLine orient(int line, const std::vector<double>& parameters) const;

private:
  struct Data;
  std::unique_ptr<const Data> data_;
};

/// All lines resampled and oriented, on up to `threads` threads; same bytes for any number.
OrientedScan orientLines(const FittedScan& scan, const ResampleOptions& resample, NormalMode mode, int threads = 1);

}  // namespace scan_to_path::scan

namespace scan_to_path {
template <>
struct EnumNames<scan::NormalMode> {
  static constexpr std::array<const char*, 3> names = {"weighted", "seed", "surface"};
};
}  // namespace scan_to_path
