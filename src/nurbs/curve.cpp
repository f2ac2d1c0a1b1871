// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/curve.h"

#include <string>

#include "control_points.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::nurbs {
namespace {

double weightAt(const Curve& curve, std::size_t i) { return curve.weights.empty() ? 1.0 : curve.weights[i]; }

}  // namespace

CurvePoint evaluate(const Curve& curve, double u) {
  const auto count = static_cast<std::size_t>(curve.degree) + 1;
  const std::size_t span = findSpan(curve.knots, curve.degree, u);
  const std::size_t first = span + 1 - count;
  double basis[3 * (max_degree + 1)];
  basisDerivatives(curve.knots, curve.degree, span, u, 2, basis);
  Vector3 A[3] = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};  // derivatives of the weighted numerator
  double w[3] = {0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < count; ++j) {
      const double factor = basis[k * count + j] * weightAt(curve, first + j);
      A[k] += factor * curve.control_points[first + j];
      w[k] += factor;
    }
  }
  if (curve.weights.empty()) return {A[0], A[1], A[2]};
  CurvePoint result;  // (4.8) of The NURBS Book, A4.2
  result.point = A[0] / w[0];
  result.first = (A[1] - w[1] * result.point) / w[0];
  result.second = (A[2] - 2.0 * w[1] * result.first - w[2] * result.point) / w[0];
  return result;
}

Vector3 pointAt(const Curve& curve, double u) {
  const auto count = static_cast<std::size_t>(curve.degree) + 1;
  const std::size_t span = findSpan(curve.knots, curve.degree, u);
  const std::size_t first = span + 1 - count;
  double basis[max_degree + 1];
  basisFunctions(curve.knots, curve.degree, span, u, basis);
  Vector3 point = Vector3::Zero();
  double w = 0.0;
  for (std::size_t j = 0; j < count; ++j) {
    const double factor = basis[j] * weightAt(curve, first + j);
    point += factor * curve.control_points[first + j];
    w += factor;
  }
  return curve.weights.empty() ? point : Vector3(point / w);
}

Curve insertKnot(const Curve& curve, double u) {
  if (!(u > curve.first() && u < curve.last())) {
    throw InputError("curve", "knot to insert", std::to_string(u),
                     "in (" + std::to_string(curve.first()) + ", " + std::to_string(curve.last()) + ")");
  }
  const auto p = static_cast<std::size_t>(curve.degree);
  const std::size_t span = findSpan(curve.knots, curve.degree, u);
  if (curve.knots[span + 1 - p] == u) {
    throw InputError("curve", "knot to insert", std::to_string(u), "present fewer than degree times");
  }
  Curve result = curve;
  result.knots.insert(result.knots.begin() + static_cast<std::ptrdiff_t>(span) + 1, u);
  result.control_points.insert(result.control_points.begin() + static_cast<std::ptrdiff_t>(span), Vector3::Zero());
  if (!curve.weights.empty()) result.weights.insert(result.weights.begin() + static_cast<std::ptrdiff_t>(span), 0.0);
  for (std::size_t i = span + 1 - p; i <= span; ++i) {  // (5.15), in homogeneous coordinates
    const double alpha = (u - curve.knots[i]) / (curve.knots[i + p] - curve.knots[i]);
    const double upper = alpha * weightAt(curve, i);
    const double lower = (1.0 - alpha) * weightAt(curve, i - 1);
    const double w = upper + lower;
    result.control_points[i] = (upper * curve.control_points[i] + lower * curve.control_points[i - 1]) / w;
    if (!curve.weights.empty()) result.weights[i] = w;
  }
  return result;
}

void validate(const Curve& curve) {
  validateKnots(curve.knots, curve.degree, curve.control_points.size(), "curve");
  validateControlPoints(curve.control_points, curve.weights, "curve");
}

}  // namespace scan_to_path::nurbs
