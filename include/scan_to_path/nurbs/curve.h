// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::nurbs {

using geometry::Vector3;

/// NURBS curve with a clamped knot vector (Piegl & Tiller, ch. 3 and 4).
/// knots.size() == control_points.size() + degree + 1; empty weights mean all 1.
struct Curve {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Vector3> control_points;  ///< [m]
  std::vector<double> weights;

  double first() const { return knots[static_cast<std::size_t>(degree)]; }
  double last() const { return knots[knots.size() - 1 - static_cast<std::size_t>(degree)]; }
};

/// A point of a curve with its derivatives by the parameter.
struct CurvePoint {
  Vector3 point = Vector3::Zero();   ///< [m]
  Vector3 first = Vector3::Zero();   ///< C'(u)
  Vector3 second = Vector3::Zero();  ///< C''(u)
};

/// Point and two derivatives at u (A3.2, A4.2). Outside the domain the end span's polynomial goes on.
CurvePoint evaluate(const Curve& curve, double u);

/// The point alone, about twice as fast.
Vector3 pointAt(const Curve& curve, double u);

/// The same curve with one more knot at u in (first, last) (A5.1).
Curve insertKnot(const Curve& curve, double u);

/// Throws InputError unless sizes agree and knots rise, are finite and clamped, and weights are positive.
void validate(const Curve& curve);

}  // namespace scan_to_path::nurbs
