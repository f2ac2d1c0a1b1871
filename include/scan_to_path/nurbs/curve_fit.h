// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/nurbs/curve.h"

namespace scan_to_path::nurbs {

/// View of a line's samples, `count` of each: parameter u and point (x, y, z) [m].
struct LineSamples {
  const double* u = nullptr;
  const double* x = nullptr;
  const double* y = nullptr;
  const double* z = nullptr;
  std::size_t count = 0;
};

/// A least-squares cubic B-spline with the evidence for it.
struct CurveFit {
  bool fitted = false;       ///< false: the samples do not determine that many control points
  Curve curve;               ///< cubic, weights 1
  std::size_t samples = 0;   ///< samples fitted
  double rms = 0.0;          ///< sqrt(RSS / n) [m], RSS summed over x, y and z
  double sigma = 0.0;        ///< noise estimate sqrt(RSS / (n - p)) [m]
  double largest_gap = 0.0;  ///< largest step of the parameter from one sample to the next
};

/// The least-squares cubic B-spline on given clamped knots (eqs 5-7): minimises the sum of |C(u_j) - p_j|^2 over all
/// control points; none is pinned to a sample. O(samples + knots); samples in any order. fitted is false when the
/// samples do not determine it. Throws InputError for bad knots, non-finite samples, parameters outside the knots.
CurveFit leastSquaresCurve(const LineSamples& samples, const std::vector<double>& knots);

}  // namespace scan_to_path::nurbs
