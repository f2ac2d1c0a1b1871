// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "cross_stencil.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace scan_to_path::scan {
namespace {

using Rows = std::array<StencilRow, stencil_rows>;

/// The weights of least norm, far rows costing more, that meet the first `conditions` of: sum w = 0, sum w s = 1,
/// sum w s^2 = 0, sum w d = 0. Nothing when they contradict each other.
std::optional<CrossStencil> solve(const Rows& rows, std::size_t count, int conditions) {
  double scale = 0.0;
  for (std::size_t i = 0; i < count; ++i) scale = std::max(scale, std::abs(rows[i].offset));
  const double unit = scale / 2.0;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 5, 5>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1>;
  Matrix A(conditions, static_cast<Eigen::Index>(count));
  Vector cheapness(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const double s = rows[i].offset / unit;
    const double all[4] = {1.0, s, s * s, rows[i].direction};
    for (int c = 0; c < conditions; ++c) A(c, column) = all[c];
    cheapness(column) = 1.0 / (1.0 + s * s * s * s);
  }
  Vector b = Vector::Zero(conditions);
  b(1) = 1.0;
  const Matrix normal = A * cheapness.asDiagonal() * A.transpose();
  const Eigen::FullPivLU<Matrix> solver(normal);
  if (!solver.isInvertible()) return std::nullopt;
  const Vector w = cheapness.asDiagonal() * A.transpose() * solver.solve(b);
  CrossStencil stencil;
  stencil.count = count;
  for (std::size_t i = 0; i < count; ++i) {
    stencil.step[i] = rows[i].step;
    stencil.weight[i] = w(static_cast<Eigen::Index>(i)) / unit;
  }
  return stencil;
}

bool mixedDirections(const Rows& rows, std::size_t count) {
  return std::any_of(rows.begin() + 1, rows.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](const StencilRow& row) { return row.direction != rows[0].direction; });
}

/// Sum of w d over the largest |w|: 0 when shifts of every other row cancel already.
double shiftSensitivity(const Rows& rows, const CrossStencil& stencil) {
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < stencil.count; ++i) {
    sum += stencil.weight[i] * rows[i].direction;
    largest = std::max(largest, std::abs(stencil.weight[i]));
  }
  return std::abs(sum) / largest;
}

}  // namespace

CrossStencil crossStencil(const StencilRow& own, const StencilRow* below, std::size_t below_count,
                          const StencilRow* above, std::size_t above_count) {
  // The nearest rows: two on each side, more on one side where the other has fewer.
  const std::size_t others = stencil_rows - 1;
  const std::size_t b = std::min(below_count, std::max<std::size_t>(2, others - std::min(above_count, others)));
  const std::size_t a = std::min(above_count, others - b);
  Rows rows{own};
  std::size_t count = 1;
  for (std::size_t k = 0; k < std::max(a, b); ++k) {
    if (k < b) rows[count++] = below[k];
    if (k < a) rows[count++] = above[k];
  }
  if (count < 2) return {};
  if (count >= 3) {
    constexpr double negligible = 0.02;  // of the shift: the next condition would cost more noise than it removes
    const auto three = solve(rows, 3, 3);
    if (three && (!mixedDirections(rows, count) || shiftSensitivity(rows, *three) < negligible)) return *three;
    if (count >= 4) {
      if (const auto all = solve(rows, count, 4)) return *all;
    }
    if (three) return *three;
  }
  const auto two = solve(rows, 2, 2);
  return two ? *two : CrossStencil{};
}

}  // namespace scan_to_path::scan
