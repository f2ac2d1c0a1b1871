// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "spline_equations.h"

#include <utility>

namespace scan_to_path::nurbs {

SplineEquations::SplineEquations(std::size_t control_points, const Lanes& origin)
    : origin_(origin), A_(control_points, 3), rows_(4 * control_points, 0.0) {
  spans_.reserve(control_points - 3);
}

void SplineEquations::add(std::size_t first, const CubicMoments& moments, const CubicSpanMatrix& basis) {
  spans_.push_back({first, moments, basis});
  const double S[7] = {moments.y[0][3], moments.y[1][3], moments.y[2][3], moments.high[0],
                       moments.high[1], moments.high[2], moments.high[3]};
  const Lanes M[4] = {Lanes::load(basis[0].data()), Lanes::load(basis[1].data()), Lanes::load(basis[2].data()),
                      Lanes::load(basis[3].data())};
  const Lanes shift = moments.reference - origin_;
  Lanes GM[4];  // Gram matrix of the monomials times M
  Lanes y[4];   // moments relative to the origin
  for (std::size_t k = 0; k < 4; ++k) {
    GM[k] = S[k] * M[0] + S[k + 1] * M[1] + S[k + 2] * M[2] + S[k + 3] * M[3];
    y[k] = moments.y[k] + S[k] * shift;
  }
  double* rhs = &rows_[4 * first];
  for (std::size_t r = 0; r < 4; ++r) {
    double row[4];
    (basis[0][r] * GM[0] + basis[1][r] * GM[1] + basis[2][r] * GM[2] + basis[3][r] * GM[3]).store(row);  // (6)
    double* band = A_.row(first + r) + 3 - r;
    for (std::size_t c = 0; c <= r; ++c) band[c] += row[c];
    const Lanes right = basis[0][r] * y[0] + basis[1][r] * y[1] + basis[2][r] * y[2] + basis[3][r] * y[3];  // (7)
    (Lanes::load(rhs + 4 * r) + right).store(rhs + 4 * r);
  }
}

bool SplineEquations::solve() {
  // Pivots stay above 1e-3 of the diagonal between uniform cubic B-splines on evenly filled spans; far below that
  // a control point hangs on a sample or two at the edge of its support.
  constexpr double tolerance = 1e-10;
  const BandedCholesky cholesky(std::move(A_), tolerance);
  if (!cholesky.positiveDefinite()) return false;
  cholesky.solve(rows_.data(), 4);
  return true;
}

double SplineEquations::rss() const {
  Lanes sum;
  for (const Span& span : spans_) {
    const double* row = &rows_[4 * span.first];
    Lanes a[4];  // the span's polynomial
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& m = span.basis[k];
      a[k] = m[0] * Lanes::load(row) + m[1] * Lanes::load(row + 4) + m[2] * Lanes::load(row + 8) +
             m[3] * Lanes::load(row + 12);
    }
    sum += CubicResidual(span.moments).of(a, origin_);
  }
  return sumOfCoordinates(sum);
}

std::vector<geometry::Vector3> SplineEquations::controlPoints() const {
  std::vector<geometry::Vector3> points;
  points.reserve(rows_.size() / 4);
  for (std::size_t i = 0; i < rows_.size(); i += 4) {
    points.emplace_back(rows_[i] + origin_[0], rows_[i + 1] + origin_[1], rows_[i + 2] + origin_[2]);
  }
  return points;
}

}  // namespace scan_to_path::nurbs
