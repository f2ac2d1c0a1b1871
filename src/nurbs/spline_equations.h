// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "cubic_moments.h"
#include "scan_to_path/nurbs/banded_cholesky.h"

namespace scan_to_path::nurbs {

/// The normal equations of a cubic spline (eq 6, 7) and their solution, relative to an origin.
struct NormalEquations {
  BandedMatrix A;
  std::vector<double> rhs;  // rows of x, y, z, 1

  explicit NormalEquations(std::size_t control_points) : A(control_points, 3), rhs(4 * control_points, 0.0) {}

  void add(std::size_t span, const CubicMoments& moments, const CubicSpanMatrix& basis) {
    addNormalEquations(moments, basis, A.row(span), &rhs[4 * span]);
  }

  /// Control points in place of the right-hand sides; false when the samples do not determine them.
  bool solve() {
    // Between uniform cubic B-splines on filled spans pivots stay above 1e-3 of the diagonal.
    constexpr double tolerance = 1e-10;
    const BandedCholesky cholesky(std::move(A), tolerance);
    if (!cholesky.positiveDefinite()) return false;
    cholesky.solve(rhs.data(), 4);
    return true;
  }
};

/// The solved rows, less the constant, as points.
inline std::vector<Vector3> controlPoints(const std::vector<double>& rows, const Lanes& origin) {
  std::vector<Vector3> points;
  points.reserve(rows.size() / 4);
  for (std::size_t i = 0; i < rows.size(); i += 4) {
    points.emplace_back(rows[i] + origin[0], rows[i + 1] + origin[1], rows[i + 2] + origin[2]);
  }
  return points;
}

/// Coefficients of the spline's polynomial on one span, lanes x, y, z, 1.
inline void spanPolynomial(const CubicSpanMatrix& basis, const double* rows, Lanes a[4]) {
  for (std::size_t k = 0; k < 4; ++k) {
    a[k] = basis[k][0] * Lanes::load(rows) + basis[k][1] * Lanes::load(rows + 4) +
           basis[k][2] * Lanes::load(rows + 8) + basis[k][3] * Lanes::load(rows + 12);
  }
}

}  // namespace scan_to_path::nurbs
