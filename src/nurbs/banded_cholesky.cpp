// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/banded_cholesky.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lanes.h"

namespace scan_to_path::nurbs {
namespace {

double dot(const double* a, const double* b, std::size_t count) {
  // Four sums side by side, always added in the same order: fast, and the same bits on every processor.
  Lanes sum;
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) sum += Lanes::load(a + k) * Lanes::load(b + k);
  double tail = 0.0;
  for (; k < count; ++k) tail += a[k] * b[k];
  return sum.sum() + tail;
}

/// Row by row; fixed > 0 is the bandwidth known at compile time. Returns the first row without a positive pivot.
template <std::size_t fixed>
std::size_t factor(BandedMatrix& A, double tolerance) {
  const std::size_t b = fixed > 0 ? fixed : A.bandwidth();
  for (std::size_t i = 0; i < A.size(); ++i) {
    double* row_i = A.row(i);
    for (std::size_t offset = b - std::min(i, b); offset < b; ++offset) {
      const std::size_t j = i - b + offset;  // row j's columns i - b … j - 1 start at i - j
      const double* row_j = A.row(j);
      row_i[offset] = (row_i[offset] - dot(row_i, row_j + (i - j), offset)) * row_j[b];
    }
    const double pivot = row_i[b] - dot(row_i, row_i, b);
    if (!(pivot > tolerance * row_i[b])) return i;
    row_i[b] = 1.0 / std::sqrt(pivot);
  }
  return A.size();
}

}  // namespace

BandedCholesky::BandedCholesky(BandedMatrix A, double tolerance) : L_(std::move(A)), failed_row_(0) {
  failed_row_ = L_.bandwidth() == 3 ? factor<3>(L_, tolerance) : factor<0>(L_, tolerance);
}

void BandedCholesky::solve(double* B, std::size_t columns) const {
  const std::size_t n = L_.size();
  const std::size_t b = L_.bandwidth();
  for (std::size_t i = 0; i < n; ++i) {  // L Y = B
    const double* row = L_.row(i);
    double* y = B + i * columns;
    for (std::size_t j = i - std::min(i, b); j < i; ++j) {
      for (std::size_t c = 0; c < columns; ++c) y[c] -= row[j + b - i] * B[j * columns + c];
    }
    for (std::size_t c = 0; c < columns; ++c) y[c] *= row[b];
  }
  for (std::size_t i = n; i-- > 0;) {  // L^T X = Y
    const double* row = L_.row(i);
    double* x = B + i * columns;
    for (std::size_t c = 0; c < columns; ++c) x[c] *= row[b];
    for (std::size_t j = i - std::min(i, b); j < i; ++j) {
      for (std::size_t c = 0; c < columns; ++c) B[j * columns + c] -= row[j + b - i] * x[c];
    }
  }
}

}  // namespace scan_to_path::nurbs
