// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "thin_plate.h"

#include <algorithm>
#include <vector>

#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::nurbs {
namespace {

/// Integrals of products of derivatives of cubic B-splines, orders 0, 1, 2: [order][i * 4 + d] of functions i, i - d.
struct DerivativeProducts {
  std::vector<double> order[3];

  explicit DerivativeProducts(const std::vector<double>& knots) {
    const std::size_t count = knots.size() - 4;
    for (auto& products : order) products.assign(count * 4, 0.0);
    for (std::size_t i = 3; i < count; ++i) addSpan(i - 3, &knots[i - 2]);
  }

  double at(std::size_t k, std::size_t i, std::size_t j) const {
    const std::size_t high = std::max(i, j);
    return order[k][high * 4 + high - std::min(i, j)];
  }

private:
  void addSpan(std::size_t first, const double* six_knots) {
    CubicSpanMatrix m = cubicSpanMatrix(six_knots);
    const double half = 0.5 * (six_knots[3] - six_knots[2]);
    const double integral[7] = {2.0, 0.0, 2.0 / 3.0, 0.0, 0.4, 0.0, 2.0 / 7.0};  // of s^k over [-1, 1]
    for (auto& products : order) {
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          double sum = 0.0;
          for (std::size_t k = 0; k < 16; ++k) sum += m[k / 4][i] * m[k % 4][j] * integral[k / 4 + k % 4];
          products[(first + i) * 4 + i - j] += sum * half;
        }
      }
      for (std::size_t k = 0; k < 4; ++k) {  // differentiate by the parameter
        for (std::size_t j = 0; j < 4; ++j) m[k][j] = k < 3 ? (static_cast<double>(k) + 1.0) * m[k + 1][j] / half : 0.0;
      }
    }
  }
};

}  // namespace

void addThinPlate(const Surface& surface, double lambda, std::size_t stride_u, std::size_t stride_v, BandedMatrix& A) {
  const DerivativeProducts u(surface.knots_u);
  const DerivativeProducts v(surface.knots_v);
  for (std::size_t row = 0; row < A.size(); ++row) {
    const std::size_t i = stride_u > stride_v ? row / stride_u : row % stride_v;
    const std::size_t j = stride_u > stride_v ? row % stride_u : row / stride_v;
    for (std::size_t k = i - std::min<std::size_t>(i, 3); k <= std::min(i + 3, surface.countU() - 1); ++k) {
      for (std::size_t l = j - std::min<std::size_t>(j, 3); l <= std::min(j + 3, surface.countV() - 1); ++l) {
        const std::size_t column = k * stride_u + l * stride_v;
        if (column > row) continue;
        A.at(row, column) += lambda * (u.at(2, i, k) * v.at(0, j, l) + 2.0 * u.at(1, i, k) * v.at(1, j, l) +
                                       u.at(0, i, k) * v.at(2, j, l));
      }
    }
  }
}

}  // namespace scan_to_path::nurbs
