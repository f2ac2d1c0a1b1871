// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/knot_vector.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"

namespace scan_to_path::nurbs {
namespace {

constexpr int max_count = max_degree + 1;

/// Table of A2.3: ndu[j][r] holds basis functions (r <= j transposed) above and knot differences below the diagonal.
struct BasisTable {
  double ndu[max_count][max_count];

  BasisTable(const std::vector<double>& knots, int degree, std::size_t span, double u) {
    double left[max_count];
    double right[max_count];
    ndu[0][0] = 1.0;
    for (int j = 1; j <= degree; ++j) {
      left[j] = u - knots[span + 1 - static_cast<std::size_t>(j)];
      right[j] = knots[span + static_cast<std::size_t>(j)] - u;
      double saved = 0.0;
      for (int r = 0; r < j; ++r) {
        ndu[j][r] = right[r + 1] + left[j - r];
        const double term = ndu[r][j - 1] / ndu[j][r];
        ndu[r][j] = saved + right[r + 1] * term;
        saved = left[j - r] * term;
      }
      ndu[j][j] = saved;
    }
  }

  /// Derivatives 1 … order of basis function r into column r of `values`, without the factor p! / (p - k)!.
  void differentiate(int degree, int r, int order, double* values) const {
    double rows[2][max_count] = {{1.0}, {0.0}};
    for (int k = 1; k <= order; ++k) {
      const double* a = rows[(k + 1) % 2];
      double* b = rows[k % 2];
      const int rk = r - k;
      const int pk = degree - k;
      double d = 0.0;
      if (r >= k) {
        b[0] = a[0] / ndu[pk + 1][rk];
        d = b[0] * ndu[rk][pk];
      }
      const int first = rk >= -1 ? 1 : -rk;
      const int last = r - 1 <= pk ? k - 1 : degree - r;
      for (int j = first; j <= last; ++j) {
        b[j] = (a[j] - a[j - 1]) / ndu[pk + 1][rk + j];
        d += b[j] * ndu[rk + j][pk];
      }
      if (r <= pk) {
        b[k] = -a[k - 1] / ndu[pk + 1][r];
        d += b[k] * ndu[r][pk];
      }
      values[k * (degree + 1) + r] = d;
    }
  }
};

}  // namespace

std::size_t findSpan(const std::vector<double>& knots, int degree, double u) {
  // Searching the inner knots only makes the last span closed and leaves the end spans open outwards.
  const auto inner_first = knots.begin() + degree + 1;
  const auto inner_end = knots.end() - degree - 1;
  return static_cast<std::size_t>(std::upper_bound(inner_first, inner_end, u) - knots.begin()) - 1;
}

void basisFunctions(const std::vector<double>& knots, int degree, std::size_t span, double u, double* values) {
  double left[max_count];
  double right[max_count];
  values[0] = 1.0;
  for (int j = 1; j <= degree; ++j) {
    left[j] = u - knots[span + 1 - static_cast<std::size_t>(j)];
    right[j] = knots[span + static_cast<std::size_t>(j)] - u;
    double saved = 0.0;
    for (int r = 0; r < j; ++r) {
      const double term = values[r] / (right[r + 1] + left[j - r]);
      values[r] = saved + right[r + 1] * term;
      saved = left[j - r] * term;
    }
    values[j] = saved;
  }
}

void basisDerivatives(const std::vector<double>& knots, int degree, std::size_t span, double u, int order,
                      double* values) {
  const BasisTable table(knots, degree, span, u);
  const int count = degree + 1;
  std::fill(values, values + (order + 1) * count, 0.0);
  const int reached = std::min(order, degree);
  for (int r = 0; r <= degree; ++r) {
    values[r] = table.ndu[r][degree];
    table.differentiate(degree, r, reached, values);
  }
  double factor = 1.0;
  for (int k = 1; k <= reached; ++k) {
    factor *= degree - k + 1;
    for (int r = 0; r <= degree; ++r) values[k * count + r] *= factor;
  }
}

std::vector<double> clampedUniformKnots(double first, double last, int control_points, int degree) {
  if (!(first < last) || !std::isfinite(first) || !std::isfinite(last)) {
    throw InputError("knot vector", "last knot", std::to_string(last), "above the first, " + std::to_string(first));
  }
  if (degree < 1 || degree > max_degree || control_points <= degree) {
    throw InputError("knot vector", "number of control points", std::to_string(control_points),
                     "above the degree, " + std::to_string(degree));
  }
  const int spans = control_points - degree;
  std::vector<double> knots(static_cast<std::size_t>(control_points + degree + 1), first);
  for (int i = 1; i < spans; ++i) {
    knots[static_cast<std::size_t>(degree + i)] = first + (last - first) * i / spans;
  }
  std::fill(knots.end() - degree - 1, knots.end(), last);
  return knots;
}

std::vector<double> grevilleAbscissae(const std::vector<double>& knots, int degree) {
  const std::size_t count = knots.size() - static_cast<std::size_t>(degree) - 1;
  std::vector<double> abscissae(count);
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0;
    for (int j = 1; j <= degree; ++j) sum += knots[i + static_cast<std::size_t>(j)];
    abscissae[i] = sum / degree;
  }
  return abscissae;
}

void validateKnots(const std::vector<double>& knots, int degree, std::size_t control_points, const std::string& where) {
  if (degree < 1 || degree > max_degree) {
    throw InputError(where, "degree", std::to_string(degree), "in [1, " + std::to_string(max_degree) + "]");
  }
  const auto p = static_cast<std::size_t>(degree);
  if (control_points <= p) {
    throw InputError(where, "number of control points", std::to_string(control_points),
                     "above the degree, " + std::to_string(degree));
  }
  if (knots.size() != control_points + p + 1) {
    throw InputError(where, "number of knots", std::to_string(knots.size()),
                     std::to_string(control_points + p + 1) + " (control points + degree + 1)");
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const std::string name = "knot " + std::to_string(i);
    if (!std::isfinite(knots[i])) throw InputError(where, name, std::to_string(knots[i]), "finite");
    if (i > 0 && knots[i] < knots[i - 1]) {
      throw InputError(where, name, std::to_string(knots[i]),
                       "at least the knot before, " + std::to_string(knots[i - 1]));
    }
    const bool inner = i > p && i < control_points;
    if (inner && knots[i] == knots[i - p]) {
      throw InputError(where, name, "repeated more than " + std::to_string(degree) + " times", "repeated less");
    }
  }
  if (knots[0] != knots[p] || knots[control_points] != knots.back()) {
    throw InputError(where, "knot vector", "not clamped", "clamped (degree + 1 equal knots at both ends)");
  }
  if (!(knots[p] < knots[p + 1]) || !(knots[control_points - 1] < knots[control_points])) {
    throw InputError(where, "end knot", "repeated more than degree + 1 times", "repeated degree + 1 times");
  }
}

CubicSpanMatrix cubicSpanMatrix(const double* six_knots) {
  const double* t = six_knots + 2;  // t[0], t[1]: the span; t[-2] … t[3] are used
  const double h = t[1] - t[0];
  const double a = h * h / ((t[1] - t[-1]) * (t[1] - t[-2]));
  const double across = 1.0 / ((t[2] - t[-1]) * (t[1] - t[-1]));
  const double before = t[0] - t[-1];
  const double m02 = before * before * across;
  const double m12 = 3.0 * h * before * across;
  const double m22 = 3.0 * h * h * across;
  const double m33 = h * h / ((t[3] - t[0]) * (t[2] - t[0]));
  const double m32 = -m22 / 3.0 - m33 - h * h / ((t[2] - t[0]) * (t[2] - t[-1]));
  // Columns: basis functions; rows: powers of tau = (u - t_i) / h.
  const double m[4][4] = {{a, 1.0 - a - m02, m02, 0.0},
                          {-3.0 * a, 3.0 * a - m12, m12, 0.0},
                          {3.0 * a, -3.0 * a - m22, m22, 0.0},
                          {-a, a - m32 - m33, m32, m33}};
  CubicSpanMatrix centred;
  for (std::size_t j = 0; j < 4; ++j) {  // tau = (1 + s) / 2
    centred[0][j] = m[0][j] + m[1][j] / 2.0 + m[2][j] / 4.0 + m[3][j] / 8.0;
    centred[1][j] = m[1][j] / 2.0 + m[2][j] / 2.0 + m[3][j] * 0.375;
    centred[2][j] = m[2][j] / 4.0 + m[3][j] * 0.375;
    centred[3][j] = m[3][j] / 8.0;
  }
  return centred;
}

}  // namespace scan_to_path::nurbs
