// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/surface.h"

#include <string>

#include "control_points.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::nurbs {
namespace {

/// Sum of basis derivatives (ku, kv) times weighted control points, and of the weights alone.
struct Numerator {
  Vector3 A = Vector3::Zero();
  double w = 0.0;
};

struct LocalBasis {
  std::size_t count;
  std::size_t first;
  double values[3 * (max_degree + 1)];

  LocalBasis(const std::vector<double>& knots, int degree, double parameter)
      : count(static_cast<std::size_t>(degree) + 1), first(0) {
    const std::size_t span = findSpan(knots, degree, parameter);
    first = span + 1 - count;
    basisDerivatives(knots, degree, span, parameter, 2, values);
  }
};

Numerator numerator(const Surface& surface, const LocalBasis& u, const LocalBasis& v, std::size_t ku, std::size_t kv) {
  Numerator sum;
  for (std::size_t i = 0; i < u.count; ++i) {
    for (std::size_t j = 0; j < v.count; ++j) {
      const std::size_t index = (u.first + i) * surface.countV() + v.first + j;
      const double weight = surface.weights.empty() ? 1.0 : surface.weights[index];
      const double factor = u.values[ku * u.count + i] * v.values[kv * v.count + j] * weight;
      sum.A += factor * surface.control_points[index];
      sum.w += factor;
    }
  }
  return sum;
}

}  // namespace

SurfaceDerivatives evaluate(const Surface& surface, double u, double v) {
  const LocalBasis basis_u(surface.knots_u, surface.degree_u, u);
  const LocalBasis basis_v(surface.knots_v, surface.degree_v, v);
  const auto part = [&](std::size_t ku, std::size_t kv) { return numerator(surface, basis_u, basis_v, ku, kv); };
  const Numerator n00 = part(0, 0);
  const Numerator n10 = part(1, 0);
  const Numerator n01 = part(0, 1);
  const Numerator n20 = part(2, 0);
  const Numerator n11 = part(1, 1);
  const Numerator n02 = part(0, 2);
  if (surface.weights.empty()) return {n00.A, n10.A, n01.A, n20.A, n11.A, n02.A};
  SurfaceDerivatives S;  // (4.20) of The NURBS Book, A4.4
  S.point = n00.A / n00.w;
  S.u = (n10.A - n10.w * S.point) / n00.w;
  S.v = (n01.A - n01.w * S.point) / n00.w;
  S.uu = (n20.A - 2.0 * n10.w * S.u - n20.w * S.point) / n00.w;
  S.uv = (n11.A - n10.w * S.v - n01.w * S.u - n11.w * S.point) / n00.w;
  S.vv = (n02.A - 2.0 * n01.w * S.v - n02.w * S.point) / n00.w;
  return S;
}

void validate(const Surface& surface) {
  const auto controls = [](const std::vector<double>& knots, int degree) {
    const std::size_t rest = static_cast<std::size_t>(degree < 0 ? 0 : degree) + 1;
    return knots.size() > rest ? knots.size() - rest : 0;
  };
  const std::size_t count_u = controls(surface.knots_u, surface.degree_u);
  const std::size_t count_v = controls(surface.knots_v, surface.degree_v);
  validateKnots(surface.knots_u, surface.degree_u, count_u, "surface, direction u");
  validateKnots(surface.knots_v, surface.degree_v, count_v, "surface, direction v");
  if (surface.control_points.size() != count_u * count_v) {
    throw InputError("surface", "number of control points", std::to_string(surface.control_points.size()),
                     std::to_string(count_u) + " x " + std::to_string(count_v));
  }
  validateControlPoints(surface.control_points, surface.weights, "surface");
}

}  // namespace scan_to_path::nurbs
