// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/random.h"
#include "scan_to_path/geometry/height_field.h"

namespace scan_to_path::geometry {
namespace {

TEST(SPart, BoundsHoldEverywhere) {
  // The constants that SPart hands to its base, found again from the formula.
  const SPart part;
  double bending = 0.0;
  double height = 0.0;
  for (int i = 0; i <= 300; ++i) {
    for (int j = 0; j <= 300; ++j) {
      const HeightJet jet = part.jet(0.24 * i / 300, 0.16 * j / 300);
      const double mean = 0.5 * (jet.zxx + jet.zyy);
      bending = std::max(bending, std::abs(mean) + std::hypot(0.5 * (jet.zxx - jet.zyy), jet.zxy));
      height = std::max(height, std::abs(jet.z));
    }
  }
  EXPECT_LT(bending, 0.023 * std::pow(2 * M_PI / 0.24, 2) + 0.003 * (2 * M_PI / 0.24) * (M_PI / 0.16));
  EXPECT_LT(height, 0.027);
}

TEST(SPart, IsTheSpecifiedFormula) {
  const SPart part;
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const double x = random.uniform(0, 0.24);
    const double y = random.uniform(0, 0.16);
    const double z = 0.020 * std::sin(2 * M_PI * (x - 0.12) / 0.24) + 0.004 * std::cos(M_PI * (y - 0.08) / 0.16) +
                     0.003 * std::sin(2 * M_PI * x / 0.24) * std::sin(M_PI * y / 0.16);
    // A few roundings of 0.02 m.
    EXPECT_NEAR(part.jet(x, y).z, z, 2e-17);
  }
}

}  // namespace
}  // namespace scan_to_path::geometry
