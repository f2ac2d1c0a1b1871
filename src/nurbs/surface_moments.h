// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "lanes.h"
#include "scan_to_path/nurbs/banded_cholesky.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "scan_to_path/nurbs/surface_fit.h"

namespace scan_to_path::nurbs {

/// Everything that the least-squares fit of one bicubic polynomial w(s, t) to samples needs to know of them;
/// s and t run over [-1, 1] in the cell. Lanes hold four powers of s, rows are powers of t.
struct BicubicMoments {
  Lanes low[7];      ///< [l]: sums of t^l s^0 … s^3
  Lanes high[7];     ///< [l]: sums of t^l s^4 … s^7 (the last is not used)
  Lanes heights[4];  ///< [l]: sums of w t^l s^0 … s^3

  double count() const { return low[0][0]; }
};

/// Moments of samples on a grid of cells over their bounding rectangle, or merged from such.
struct MomentGrid {
  std::size_t cells_u = 0;
  std::size_t cells_v = 0;
  std::vector<BicubicMoments> cells;  ///< cell (i, j) at i * cells_v + j

  const BicubicMoments& at(std::size_t i, std::size_t j) const { return cells[i * cells_v + j]; }
  BicubicMoments& at(std::size_t i, std::size_t j) { return cells[i * cells_v + j]; }
};

/// Where the samples lie and what they sum up to.
struct HeightMoments {
  double first_u = 0.0;
  double last_u = 0.0;
  double first_v = 0.0;
  double last_v = 0.0;
  double reference = 0.0;  ///< height that is subtracted [m]
  double squares = 0.0;    ///< sum of (w - reference)^2 [m^2]
  double samples = 0.0;
  MomentGrid grid;
};

/// One pass over the samples. Throws InputError when there are none, one is not finite, or they span no rectangle.
HeightMoments accumulateHeights(const std::vector<HeightSamples>& lines, std::size_t cells_u, std::size_t cells_v);

/// Cells merged into spans that end at the given cell edges.
MomentGrid mergeU(const MomentGrid& grid, const std::vector<int>& ends);
MomentGrid mergeV(const MomentGrid& grid, const std::vector<int>& ends);

/// Adds a patch's part to the normal equations: element ((i, j), (k, l)) of its 16 x 16 matrix, i and k in u, goes to
/// rows first + i * stride_u + j * stride_v of A's lower triangle, and likewise its right-hand side.
void addPatch(const BicubicMoments& patch, const CubicSpanMatrix& basis_u, const CubicSpanMatrix& basis_v,
              std::size_t first, std::size_t stride_u, std::size_t stride_v, BandedMatrix& A, std::vector<double>& rhs);

}  // namespace scan_to_path::nurbs
