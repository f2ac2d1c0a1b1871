// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::nurbs {

using geometry::Vector3;

/// Tensor-product NURBS surface with clamped knot vectors (Piegl & Tiller, ch. 3 and 4).
/// Control point (i, j) is control_points[i * count_v() + j]; empty weights mean all 1.
struct Surface {
  int degree_u = 3;
  int degree_v = 3;
  std::vector<double> knots_u;
  std::vector<double> knots_v;
  std::vector<Vector3> control_points;  ///< [m]
  std::vector<double> weights;

  std::size_t countU() const { return knots_u.size() - static_cast<std::size_t>(degree_u) - 1; }
  std::size_t countV() const { return knots_v.size() - static_cast<std::size_t>(degree_v) - 1; }
};

/// A surface point with its partial derivatives.
struct SurfaceDerivatives {
  Vector3 point = Vector3::Zero();  ///< [m]
  Vector3 u = Vector3::Zero();
  Vector3 v = Vector3::Zero();
  Vector3 uu = Vector3::Zero();
  Vector3 uv = Vector3::Zero();
  Vector3 vv = Vector3::Zero();
};

/// Point and partial derivatives up to the second order (A3.6, A4.4).
SurfaceDerivatives evaluate(const Surface& surface, double u, double v);

/// Throws InputError unless sizes agree and knots rise, are finite and clamped, and weights are positive.
void validate(const Surface& surface);

}  // namespace scan_to_path::nurbs
