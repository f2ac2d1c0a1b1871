// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace scan_to_path::nurbs {

/// Lower triangle of a symmetric banded matrix, rows one after another: row i holds columns i - bandwidth … i.
/// Elements left of column 0 exist and stay 0.
class BandedMatrix {
public:
  BandedMatrix(std::size_t size, std::size_t bandwidth)
      : size_(size), bandwidth_(bandwidth), elements_(size * (bandwidth + 1), 0.0) {}

  std::size_t size() const { return size_; }
  std::size_t bandwidth() const { return bandwidth_; }

  /// Element (row, column). Precondition: row - bandwidth <= column <= row.
  double& at(std::size_t row, std::size_t column) {
    return elements_[row * (bandwidth_ + 1) + column + bandwidth_ - row];
  }
  double at(std::size_t row, std::size_t column) const {
    return elements_[row * (bandwidth_ + 1) + column + bandwidth_ - row];
  }

  double* row(std::size_t i) { return &elements_[i * (bandwidth_ + 1)]; }
  const double* row(std::size_t i) const { return &elements_[i * (bandwidth_ + 1)]; }

private:
  std::size_t size_;
  std::size_t bandwidth_;
  std::vector<double> elements_;
};

/// Cholesky factor L of a symmetric banded matrix, A = L L^T (Golub & Van Loan, algorithm 4.3.5):
/// O(size * bandwidth^2), no fill outside the band.
class BandedCholesky {
public:
  /// Factors A in place of the argument. A pivot at or below `tolerance` times its diagonal element of A means that
  /// A is not numerically positive definite: positiveDefinite() is then false and failedRow() says where.
  explicit BandedCholesky(BandedMatrix A, double tolerance = 1e-14);

  bool positiveDefinite() const { return failed_row_ == L_.size(); }
  std::size_t failedRow() const { return failed_row_; }

  /// Solves A X = B in place; B is size x columns, row-major. Precondition: positiveDefinite().
  void solve(double* B, std::size_t columns) const;

private:
  BandedMatrix L_;  // the diagonal holds the reciprocals
  std::size_t failed_row_;
};

}  // namespace scan_to_path::nurbs
