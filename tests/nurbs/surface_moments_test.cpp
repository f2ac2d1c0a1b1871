// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/nurbs/surface_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../src/nurbs/span_layout.h"
#include "support/expect_input_error.h"
#include "support/spline_lines.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;
using test::SampledLine;

/// Heights over [0, 4] x [0, 3], a sample on every corner of it.
SampledLine scattered(Random& random, int count) {
  SampledLine line;
  for (const auto& [u, v] : {std::pair(0.0, 0.0), std::pair(4.0, 0.0), std::pair(0.0, 3.0), std::pair(4.0, 3.0)}) {
    line.add(u, u, v, 0.3);
  }
  for (int i = 0; i < count; ++i) {
    const double u = 4.0 * random.uniform(), v = 3.0 * random.uniform();
    line.add(u, u, v, std::sin(u) * v + 0.1 * random.gaussian());
  }
  return line;
}

/// Sum over the samples of the cell [a, a + width) x [b, b + height) of w^h s^k t^l with s, t in [-1, 1] there.
double directSum(const SampledLine& line, double reference, double a, double width, double b, double height, int h,
                 int k, int l) {
  double sum = 0.0;
  for (std::size_t i = 0; i < line.u.size(); ++i) {
    const double s = 2.0 * (line.x[i] - a) / width - 1.0, t = 2.0 * (line.y[i] - b) / height - 1.0;
    const bool in_u = s >= -1.0 && (s < 1.0 || (s == 1.0 && line.x[i] == 4.0));
    const bool in_v = t >= -1.0 && (t < 1.0 || (t == 1.0 && line.y[i] == 3.0));
    if (in_u && in_v) sum += std::pow(line.z[i] - reference, h) * std::pow(s, k) * std::pow(t, l);
  }
  return sum;
}

void expectMoments(const BicubicMoments& cell, const SampledLine& line, double reference, double a, double width,
                   double b, double height) {
  // At most 500 terms of at most 4, rounded at 1e-16 and mapped with factors of at most 2^6.
  constexpr double rounding = 2e-11;
  for (int l = 0; l < 7; ++l) {
    for (int k = 0; k < 4; ++k) {
      const auto lane = static_cast<std::size_t>(k);
      EXPECT_NEAR(cell.low[l][lane], directSum(line, reference, a, width, b, height, 0, k, l), rounding);
      if (k < 3) {
        EXPECT_NEAR(cell.high[l][lane], directSum(line, reference, a, width, b, height, 0, k + 4, l), rounding);
      }
      if (l < 4) {
        EXPECT_NEAR(cell.heights[l][lane], directSum(line, reference, a, width, b, height, 1, k, l), rounding);
      }
    }
  }
}

TEST(SurfaceMoments, CellsHoldTheSumsOverTheirSamples) {
  Random random(1);
  const SampledLine line = scattered(random, 500);
  const HeightMoments moments = accumulateHeights({line.heights()}, 4, 3);
  EXPECT_EQ(moments.samples, 504.0);
  EXPECT_EQ(moments.reference, line.z[0]);
  EXPECT_EQ(moments.first_u, 0.0);
  EXPECT_EQ(moments.last_v, 3.0);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      expectMoments(moments.grid.at(i, j), line, moments.reference, static_cast<double>(i), 1.0, static_cast<double>(j),
                    1.0);
    }
  }
}

TEST(SurfaceMoments, MergedCellsHoldTheSumsOfTheirParts) {
  Random random(2);
  const SampledLine line = scattered(random, 500);
  const HeightMoments moments = accumulateHeights({line.heights()}, 4, 3);
  const MomentGrid merged = mergeV(mergeU(moments.grid, {0, 1, 4}), {0, 2, 3});
  ASSERT_EQ(merged.cells.size(), 4U);
  expectMoments(merged.at(0, 0), line, moments.reference, 0.0, 1.0, 0.0, 2.0);
  expectMoments(merged.at(0, 1), line, moments.reference, 0.0, 1.0, 2.0, 1.0);
  expectMoments(merged.at(1, 0), line, moments.reference, 1.0, 3.0, 0.0, 2.0);
  expectMoments(merged.at(1, 1), line, moments.reference, 1.0, 3.0, 2.0, 1.0);
}

TEST(SurfaceMoments, APatchAddsItsBasisFunctionsProducts) {
  Random random(3);
  const SampledLine line = scattered(random, 100);
  const HeightMoments moments = accumulateHeights({line.heights()}, 1, 1);
  const CubicSpanMatrix basis_u = spanMatrix({0, 1, 2, 3, 4}, 1), basis_v = spanMatrix({0, 1, 2}, 0);
  constexpr std::size_t stride_u = 5, stride_v = 1;
  BandedMatrix A(20, 19);
  std::vector<double> rhs(20, 0.0);
  addPatch(moments.grid.at(0, 0), basis_u, basis_v, 0, stride_u, stride_v, A, rhs);
  const auto value = [](const CubicSpanMatrix& basis, std::size_t j, double s) {
    return basis[0][j] + s * (basis[1][j] + s * (basis[2][j] + s * basis[3][j]));
  };
  const auto function = [&](std::size_t row, std::size_t sample) {
    const double s = 0.5 * line.x[sample] - 1.0, t = line.y[sample] / 1.5 - 1.0;
    return row % stride_u < 4 ? value(basis_u, row / stride_u, s) * value(basis_v, row % stride_u, t) : 0.0;
  };
  for (std::size_t row = 0; row < 20; ++row) {
    double right = 0.0;
    for (std::size_t i = 0; i < line.u.size(); ++i) right += function(row, i) * (line.z[i] - moments.reference);
    EXPECT_NEAR(rhs[row], right, 1e-12);
    for (std::size_t column = 0; column <= row; ++column) {
      double product = 0.0;
      for (std::size_t i = 0; i < line.u.size(); ++i) product += function(row, i) * function(column, i);
      EXPECT_NEAR(A.at(row, column), product, 1e-12) << row << " " << column;
    }
  }
}

TEST(SurfaceMoments, RefusesWhatSpansNoRectangle) {
  expectInputError([] { accumulateHeights({}, 1, 1); }, "number of samples is 0");
  SampledLine line;
  line.add(0.0, 0.0, 1.0, 0.0);
  line.add(1.0, 1.0, 1.0, 0.0);
  expectInputError([&line] { accumulateHeights({line.heights()}, 1, 1); }, "range of v is 0");
  line.z[1] = std::numeric_limits<double>::quiet_NaN();
  expectInputError([&line] { accumulateHeights({line.heights()}, 1, 1); }, "w of sample 1 of line 0");
}

}  // namespace
}  // namespace scan_to_path::nurbs
