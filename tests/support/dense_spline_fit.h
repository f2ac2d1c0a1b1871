// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>

#include "scan_to_path/nurbs/curve_fit.h"
#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::test {

/// Least squares on the collocation matrix itself by Householder QR: no normal equations, no moments.
struct DenseSplineFit {
  Eigen::MatrixXd control_points;  ///< count x 3
  double rss = 0.0;
};

inline Eigen::MatrixXd collocationMatrix(const nurbs::LineSamples& samples, const std::vector<double>& knots) {
  Eigen::MatrixXd A =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(samples.count), static_cast<Eigen::Index>(knots.size()) - 4);
  for (std::size_t i = 0; i < samples.count; ++i) {
    const std::size_t span = nurbs::findSpan(knots, 3, samples.u[i]);
    double basis[4];
    nurbs::basisFunctions(knots, 3, span, samples.u[i], basis);
    for (int j = 0; j < 4; ++j) A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(span) - 3 + j) = basis[j];
  }
  return A;
}

inline DenseSplineFit denseSplineFit(const nurbs::LineSamples& samples, const std::vector<double>& knots) {
  const Eigen::MatrixXd A = collocationMatrix(samples, knots);
  Eigen::MatrixXd P(A.rows(), 3);
  for (Eigen::Index i = 0; i < A.rows(); ++i) P.row(i) << samples.x[i], samples.y[i], samples.z[i];
  DenseSplineFit fit;
  fit.control_points = A.colPivHouseholderQr().solve(P);
  fit.rss = (A * fit.control_points - P).squaredNorm();
  return fit;
}

}  // namespace scan_to_path::test
