// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/banded_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "scan_to_path/common/random.h"

namespace scan_to_path::nurbs {
namespace {

/// Diagonally dominant, hence positive definite.
BandedMatrix randomMatrix(Random& random, std::size_t size, std::size_t bandwidth) {
  BandedMatrix A(size, bandwidth);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i - std::min(i, bandwidth); j < i; ++j) A.at(i, j) = random.uniform(-1.0, 1.0);
    A.at(i, i) = 2.0 * static_cast<double>(bandwidth) + random.uniform(0.5, 1.0);
  }
  return A;
}

Eigen::MatrixXd dense(const BandedMatrix& A) {
  const auto n = static_cast<Eigen::Index>(A.size());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < A.size(); ++i) {
    for (std::size_t j = i - std::min(i, A.bandwidth()); j <= i; ++j) {
      const auto row = static_cast<Eigen::Index>(i);
      const auto column = static_cast<Eigen::Index>(j);
      full(row, column) = full(column, row) = A.at(i, j);
    }
  }
  return full;
}

TEST(BandedCholesky, SolvesAsTheDenseFactorisation) {
  Random random(1);
  for (int round = 0; round < 100; ++round) {
    const std::size_t n = 1 + static_cast<std::size_t>(random.uniform(0.0, 40.0));
    const std::size_t bandwidth = round % 3 == 0 ? 3 : static_cast<std::size_t>(random.uniform(0.0, 20.0));
    const std::size_t columns = round % 2 == 0 ? 4 : 1 + static_cast<std::size_t>(random.uniform(0.0, 6.0));
    const BandedMatrix A = randomMatrix(random, n, bandwidth);
    std::vector<double> B(n * columns);
    for (double& b : B) b = random.gaussian();
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto rows = static_cast<Eigen::Index>(n);
    const RowMajor right = Eigen::Map<RowMajor>(B.data(), rows, static_cast<Eigen::Index>(columns));
    const BandedCholesky cholesky(A);
    ASSERT_TRUE(cholesky.positiveDefinite());
    cholesky.solve(B.data(), columns);
    const Eigen::Map<RowMajor> X(B.data(), rows, static_cast<Eigen::Index>(columns));
    // Condition below 10, at most 40 roundings per element of size 1.
    EXPECT_LT((X - dense(A).ldlt().solve(right)).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(BandedCholesky, ReportsTheRowWithoutAPositivePivot) {
  Random random(2);
  for (const std::size_t bandwidth : {std::size_t{3}, std::size_t{7}}) {
    BandedMatrix A = randomMatrix(random, 20, bandwidth);
    A.at(11, 11) = -1.0;
    const BandedCholesky cholesky(A);
    EXPECT_FALSE(cholesky.positiveDefinite());
    EXPECT_EQ(cholesky.failedRow(), 11u);
  }
}

TEST(BandedCholesky, RefusesASingularMatrix) {
  BandedMatrix A(3, 1);  // second differences without a boundary condition: constants are its null space
  A.at(0, 0) = A.at(2, 2) = 1.0;
  A.at(1, 1) = 2.0;
  A.at(1, 0) = A.at(2, 1) = -1.0;
  EXPECT_FALSE(BandedCholesky(A).positiveDefinite());
  EXPECT_EQ(BandedCholesky(A).failedRow(), 2u);
}

TEST(BandedCholesky, RefusesNumbersThatAreNone) {
  Random random(3);
  BandedMatrix A = randomMatrix(random, 10, 3);
  A.at(4, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(BandedCholesky(A).positiveDefinite());
}

}  // namespace
}  // namespace scan_to_path::nurbs
