// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/cross_stencil.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "scan_to_path/common/random.h"

namespace scan_to_path::scan {
namespace {

double power(const CrossStencil& stencil, const std::vector<StencilRow>& rows, int exponent) {
  double sum = 0.0;
  for (std::size_t k = 0; k < stencil.count; ++k) {
    for (const StencilRow& row : rows) {
      if (row.step == stencil.step[k]) sum += stencil.weight[k] * std::pow(row.offset, exponent);
    }
  }
  return sum;
}

double shift(const CrossStencil& stencil, const std::vector<StencilRow>& rows) {
  double sum = 0.0;
  for (std::size_t k = 0; k < stencil.count; ++k) {
    for (const StencilRow& row : rows) {
      if (row.step == stencil.step[k]) sum += stencil.weight[k] * row.direction;
    }
  }
  return sum;
}

/// Rows from -below to above, the point's own included.
struct Layout {
  std::vector<StencilRow> below, above, all;
  StencilRow own{0, 0.0, 1.0};

  Layout(int below_count, int above_count, bool zigzag, Random* random = nullptr) {
    all.push_back(own);
    const auto add = [&](std::vector<StencilRow>& side, int sense, int count) {
      double offset = 0.0;
      for (int k = 1; k <= count; ++k) {
        offset += sense * 0.004 * (random != nullptr ? random->uniform(0.6, 1.6) : 1.0);
        side.push_back({sense * k, offset, zigzag && k % 2 == 1 ? -1.0 : 1.0});
        all.push_back(side.back());
      }
    };
    add(below, -1, below_count);
    add(above, 1, above_count);
  }
  CrossStencil stencil() const { return crossStencil(own, below.data(), below.size(), above.data(), above.size()); }
};

TEST(CrossStencil, EvenInteriorIsTheCentralDifference) {
  for (const bool zigzag : {false, true}) {
    const CrossStencil stencil = Layout(4, 4, zigzag).stencil();
    ASSERT_EQ(stencil.count, 3u);
    EXPECT_NEAR(stencil.weight[0], 0.0, 1e-9);
    EXPECT_NEAR(stencil.weight[1], -125.0, 1e-9);
    EXPECT_NEAR(stencil.weight[2], 125.0, 1e-9);
  }
}

TEST(CrossStencil, SecondOrderAndBlindToShiftsAtAnyPitch) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    for (int below = 0; below <= 4; ++below) {
      for (int above = 0; above <= 4; ++above) {
        const Layout layout(below, above, round % 2 == 0, &random);
        const CrossStencil stencil = layout.stencil();
        const int rows = 1 + below + above;
        EXPECT_EQ(stencil.count == 0, rows == 1);
        if (rows == 1) continue;
        EXPECT_NEAR(power(stencil, layout.all, 0), 0.0, 1e-8);  // weights are some 1e3 /m
        EXPECT_NEAR(power(stencil, layout.all, 1), 1.0, 1e-10);
        if (rows >= 3) {
          EXPECT_NEAR(power(stencil, layout.all, 2), 0.0, 1e-12);
        }
        // Up to a fiftieth of a row's shift may pass where that keeps a short difference.
        if (rows >= 4) {
          EXPECT_LE(std::abs(shift(stencil, layout.all)), 0.02 * 500.0);
        }
      }
    }
  }
}

TEST(CrossStencil, TwoRowsAreAPlainDifference) {
  const CrossStencil stencil = Layout(0, 1, true).stencil();
  ASSERT_EQ(stencil.count, 2u);
  EXPECT_DOUBLE_EQ(stencil.weight[0], -250.0);
  EXPECT_DOUBLE_EQ(stencil.weight[1], 250.0);
}

}  // namespace
}  // namespace scan_to_path::scan
