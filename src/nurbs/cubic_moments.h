// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "lanes.h"
#include "scan_to_path/nurbs/curve_fit.h"

namespace scan_to_path::nurbs {

/// Everything that the least-squares fit of one cubic polynomial to samples needs to know of them. Coordinates are
/// taken relative to `reference` and the parameter is local, s in [-1, 1], so that squares keep their digits.
/// The lanes are x, y, z and the constant 1: lane 3 of y[k] is the sum of s^k.
struct CubicMoments {
  Lanes y[4];       ///< sums of s^k (x, y, z, 1), k = 0 … 3
  Lanes squares;    ///< sums of (x^2, y^2, z^2, 1)
  Lanes high;       ///< sums of s^3, s^4, s^5, s^6
  Lanes reference;  ///< [m]; lane 3 is 0

  double count() const { return y[0][3]; }
};

/// Powers of s' = alpha s + delta by powers of s: s'^k = sum over j of c[k][j] s^j.
struct LocalMap {
  double c[4][4];  ///< k, j = 0 … 3
  Lanes high[7];   ///< high[j]: coefficients of s^j in the powers 3 … 6

  LocalMap(double alpha, double delta);
};

/// Moments of samples begin … end with s = (u - centre) * inverse_half; the reference is the first of them.
CubicMoments accumulate(const LineSamples& samples, std::size_t begin, std::size_t end, double centre,
                        double inverse_half);

/// Adds the moments of a part, mapped to the whole's parameter and reference.
void addMapped(CubicMoments& whole, const CubicMoments& part, const LocalMap& map);

/// Moments factored so that the residual of any cubic is a sum of squares: with the Gram matrix G = L D L^T of the
/// monomials, |y - p|^2 = rest + sum over k of d_k ((L^T a)_k - z_k)^2 for the polynomial with coefficients a.
/// Nothing cancels but in `rest`, whose floor is about 1e-8 of the samples' extent within the block, squared.
struct CubicResidual {
  Lanes z[4];
  Lanes rest;
  Lanes reference;
  double d[4];
  double l10, l20, l21, l30, l31, l32;

  explicit CubicResidual(const CubicMoments& moments);

  /// Number of coefficients that the block's samples determine.
  int rank() const { return (d[0] > 0.0) + (d[1] > 0.0) + (d[2] > 0.0) + (d[3] > 0.0); }

  /// Squared residuals of the cubic with coefficients a[k] of s^k (coordinates less `origin`), lane by lane.
  Lanes of(const Lanes a[4], const Lanes& origin) const;
};

/// Sum of a residual's lanes x, y, z.
inline double sumOfCoordinates(const Lanes& lanes) { return (lanes[0] + lanes[1]) + lanes[2]; }

}  // namespace scan_to_path::nurbs
