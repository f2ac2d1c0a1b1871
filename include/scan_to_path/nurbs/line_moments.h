// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "scan_to_path/nurbs/curve_fit.h"

namespace scan_to_path::nurbs {

/// What a line's samples say about every cubic spline whose knots lie on a fine uniform grid of the parameter: sums
/// of s^k and s^k p per grid cell. Normal equations and residuals follow from them exactly, in time proportional to
/// the number of knots, so trying many numbers of control points costs less than reading the samples once.
///
/// Knots are uniform but for rounding to the grid (by at most an eighth of a span up to a quarter of the finest
/// spacing). Residuals are sums of squares per cell and stay above zero; rounding keeps them from meaning anything
/// below an RMS of about 1e-8 of the length of a span.
class LineMoments {
public:
  /// One pass over the samples, which may be in any order and are not kept.
  /// Throws InputError when there are none, one is not finite, or all parameters are equal.
  explicit LineMoments(const LineSamples& samples);

  std::size_t samples() const;
  double first() const;       ///< smallest parameter
  double last() const;        ///< largest parameter
  double largestGap() const;  ///< largest step of the parameter from one sample to the next

  /// Largest number of control points worth trying: from the residuals of piecewise cubics over halved cells, which
  /// bound how fine a structure the samples show. `noise` [m], 0 when unknown. At least 4.
  int usefulControlPoints(double noise = 0.0) const;

  /// Residual sum of squares [m^2] of the fit with that many control points; NaN when it is not allowed: fewer than
  /// 4, more than half the samples, beyond the grid, a span without a sample (Schoenberg-Whitney).
  double rss(int control_points) const;

  /// The fit; fitted is false where rss() is NaN.
  CurveFit fit(int control_points) const;

private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace scan_to_path::nurbs
