// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/toolpath/solid_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "support/fitted_scans.h"

namespace scan_to_path::toolpath {
namespace {

/// Distance from the columns below all the points, one by one.
double distanceByBruteForce(const std::vector<Vector3>& points, const Vector3& centre) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& p : points) {
    least = std::min(least, std::hypot(p.x() - centre.x(), p.y() - centre.y(), std::max(0.0, centre.z() - p.z())));
  }
  return least;
}

TEST(SolidPoints, FindsWhatBruteForceFinds) {
  Random random(1);
  int found_some = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<Vector3> points;
    for (int i = 0; i < 1 + 20 * round; ++i) {
      points.emplace_back(random.uniform(-0.1, 0.1), random.uniform(0.3, 0.4), random.uniform(0.0, 0.05));
    }
    const SolidPoints solid(points, random.uniform(0.001, 0.05));
    for (int i = 0; i < 50; ++i) {
      const Vector3 centre(random.uniform(-0.15, 0.15), random.uniform(0.25, 0.45), random.uniform(-0.05, 0.1));
      const double reach = random.uniform(0.001, 0.1), distance = distanceByBruteForce(points, centre);
      const auto nearest = solid.nearest(centre, reach);
      ASSERT_EQ(nearest.has_value(), distance < reach);
      if (!nearest) continue;
      ++found_some;
      EXPECT_NEAR((*nearest - centre).norm(), distance, 1e-15);
    }
  }
  EXPECT_GT(found_some, 200);
}

TEST(SolidPoints, MaterialReachesDownFromEachPoint) {
  const SolidPoints solid({Vector3(0.0, 0.0, 0.1)}, 0.01);
  const auto beside = solid.nearest({0.02, 0.0, 0.04}, 0.03);
  ASSERT_TRUE(beside.has_value());
  EXPECT_EQ(*beside, Vector3(0.0, 0.0, 0.04));
  const auto above = solid.nearest({0.0, 0.0, 0.12}, 0.03);
  ASSERT_TRUE(above.has_value());
  EXPECT_EQ(*above, Vector3(0.0, 0.0, 0.1));
  EXPECT_FALSE(solid.nearest({0.02, 0.0, 0.12}, 0.02).has_value());
}

TEST(SolidPoints, OfNothingThereIsNoneNear) {
  EXPECT_FALSE(SolidPoints({}, 0.01).nearest(Vector3::Zero(), 1e3).has_value());
}

TEST(SolidPoints, PointsOnLinesLieOnThemAndNoFartherApart) {
  const scan::FittedScan scan = test::fittedSPart();
  const double spacing = 1e-3;
  const std::vector<Vector3> points = pointsOnLines(scan, spacing);
  std::size_t i = 0;
  for (const scan::FittedLine& line : scan.lines) {
    const scan::Frame T_scan_cloud = scan.T_cloud_scan.inverse();
    const Vector3 begin = T_scan_cloud * nurbs::pointAt(line.curve, line.begin);
    const Vector3 end = T_scan_cloud * nurbs::pointAt(line.curve, line.end);
    ASSERT_LT(i, points.size());
    EXPECT_LT((points[i] - begin).norm(), 1e-15);
    for (; (points[i] - end).norm() > 1e-15; ++i) {
      ASSERT_LT(i + 1, points.size());
      // The parameter runs along x: on the part's steepest slope a step is longer than its share of x.
      EXPECT_LE((points[i + 1] - points[i]).norm(), 1.5 * spacing);
    }
    ++i;
  }
  EXPECT_EQ(i, points.size());
}

}  // namespace
}  // namespace scan_to_path::toolpath
