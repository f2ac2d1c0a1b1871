// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace scan_to_path::nurbs {

/// Largest degree that curves and surfaces may have.
constexpr int max_degree = 9;

/// Index i with knots[i] <= u < knots[i + 1] (A2.1). Spans are half-open but for the last, which is closed; outside
/// the domain the first or last span that is not empty. Precondition: clamped knots with one span of positive width.
std::size_t findSpan(const std::vector<double>& knots, int degree, double u);

/// The degree + 1 basis functions that do not vanish on `span`, at u (A2.2): values[j] is N_{span - degree + j}(u).
/// They are polynomials of the span, so u may lie outside it.
void basisFunctions(const std::vector<double>& knots, int degree, std::size_t span, double u, double* values);

/// The same with derivatives up to `order` (A2.3): values[k * (degree + 1) + j] is the k-th derivative.
void basisDerivatives(const std::vector<double>& knots, int degree, std::size_t span, double u, int order,
                      double* values);

/// Clamped knots with equal spans. Throws InputError unless first < last and control_points > degree.
std::vector<double> clampedUniformKnots(double first, double last, int control_points, int degree);

/// Means of `degree` consecutive knots, one per control point: the coefficients that reproduce u itself.
std::vector<double> grevilleAbscissae(const std::vector<double>& knots, int degree);

/// Throws InputError, with `where` in it, unless the knots are finite, rise, are clamped at both ends, no inner one
/// stands more than `degree` times, and there are control_points + degree + 1 of them.
void validateKnots(const std::vector<double>& knots, int degree, std::size_t control_points, const std::string& where);

/// Power-basis coefficients of the four cubic basis functions on one span, in its centred coordinate
/// s = 2 (u - t_i) / (t_{i+1} - t_i) - 1: element [k][j] belongs to s^k and basis function i - 3 + j.
using CubicSpanMatrix = std::array<std::array<double, 4>, 4>;

/// The matrix from the six knots t_{i-2} … t_{i+3} around the span, t_i < t_{i+1} (Qin 2000, eq 13, centred).
CubicSpanMatrix cubicSpanMatrix(const double* six_knots);

}  // namespace scan_to_path::nurbs
