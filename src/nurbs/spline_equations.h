// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cubic_moments.h"
#include "scan_to_path/nurbs/banded_cholesky.h"
#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::nurbs {

/// The least-squares problem of a cubic spline: normal equations (eqs 6, 7) put together from the moments of its
/// spans, their solution and its residual.
class SplineEquations {
public:
  /// Control points are solved for relative to `origin` (lane 3 is 0), so that they keep their digits.
  SplineEquations(std::size_t control_points, const Lanes& origin);

  /// Adds the samples of the span whose first basis function is number `first`.
  void add(std::size_t first, const CubicMoments& moments, const CubicSpanMatrix& basis);

  /// False when the samples do not determine the control points; then nothing else may be asked for.
  bool solve();

  /// Residual sum of squares over x, y and z [m^2]; never negative.
  double rss() const;

  std::vector<geometry::Vector3> controlPoints() const;

private:
  struct Span {
    std::size_t first;
    CubicMoments moments;
    CubicSpanMatrix basis;
  };

  Lanes origin_;
  BandedMatrix A_;
  std::vector<double> rows_;  // right-hand sides, then the solution: x, y, z, 1 of each control point
  std::vector<Span> spans_;
};

}  // namespace scan_to_path::nurbs
