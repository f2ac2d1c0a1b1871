// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/scan_surface.h"

#include <gtest/gtest.h>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"
#include "support/fitted_scans.h"

namespace scan_to_path::toolpath {
namespace {

TEST(ScanSurface, IsTheSurfaceItIsMadeFrom) {
  const auto scan = test::fittedSPart();
  const ScanSurface surface(scan.surface);
  const geometry::SPart part;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(0.0, 0.24), y = random.uniform(0.0, 0.16);
    const auto expected = nurbs::evaluate(scan.surface, x, y);
    const HeightJet jet = surface.jet(x, y);
    // Power form against de Boor: rounding times some hundred spans per metre for each derivative.
    EXPECT_NEAR(jet.z, expected.point.z(), 1e-15);
    EXPECT_NEAR(jet.zx, expected.u.z(), 1e-12);
    EXPECT_NEAR(jet.zyy, expected.vv.z(), 1e-8);
    EXPECT_EQ(surface.height(x, y), jet.z);
    EXPECT_NEAR(jet.z, part.jet(x, y).z, 1e-8);
  }
}

TEST(ScanSurface, HasTheAnalyticNormalsAndCurvatures) {
  const geometry::SPart part;
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(0.0, 0.24), y = random.uniform(0.0, 0.16);
    const HeightJet jet = part.jet(x, y);
    const auto at = part.at(x, y);
    const auto exact = part.curvatures(at.point);
    EXPECT_LT((normalOf(jet) - at.normal).norm(), 1e-15 * 10);
    EXPECT_NEAR(smallestCurvature(jet), exact.k_min, 1e-9);
    const auto flat = [](const Vector3& v) { return Eigen::Vector2d(v.x(), v.y()); };
    EXPECT_NEAR(normalCurvature(jet, flat(exact.direction_min)), exact.k_min, 1e-9);
    EXPECT_NEAR(normalCurvature(jet, -3.0 * flat(exact.direction_max)), exact.k_max, 1e-9);
  }
}

TEST(ScanSurface, AHollowIsNegative) {
  HeightJet bowl;
  bowl.zxx = 10.0;
  bowl.zyy = 4.0;
  EXPECT_DOUBLE_EQ(smallestCurvature(bowl), -10.0);
  EXPECT_DOUBLE_EQ(normalCurvature(bowl, Eigen::Vector2d::UnitY()), -4.0);
}

TEST(ScanSurface, RejectsWhatIsNoHeight) {
  auto scan = test::fittedSPart();
  scan.surface.control_points[5].x() += 1e-3;
  EXPECT_THROW(ScanSurface{scan.surface}, InputError);
  EXPECT_THROW(ScanSurface{nurbs::Surface{}}, InputError);
}

}  // namespace
}  // namespace scan_to_path::toolpath
