// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/nurbs/banded_cholesky.h"
#include "scan_to_path/nurbs/surface.h"

namespace scan_to_path::nurbs {

/// Adds the matrix of lambda times the integral of w_uu^2 + 2 w_uv^2 + w_vv^2 over the surface's rectangle, w being
/// a height with the surface's knots. Control point (i, j) is row i * stride_u + j * stride_v of A; the larger stride
/// is the number of control points along the other direction, the smaller one is 1.
void addThinPlate(const Surface& surface, double lambda, std::size_t stride_u, std::size_t stride_v, BandedMatrix& A);

}  // namespace scan_to_path::nurbs
