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

// On the part itself, in the scan frame although the lines are in the cloud's, each line from end to end in its order.
TEST(SolidPoints, PointsOnLinesLieOnThemAndNoFartherApart) {
  const geometry::SPart part;
  const double spacing = 1e-3;
  const scan::FittedScan scan = test::fittedSPart(geometry::makeFrame({0.4, -0.2, 0.7}, {0.3, -0.2, 1.1}));
  const std::vector<Vector3> points = pointsOnLines(scan, spacing);
  std::size_t i = 0;
  for (const scan::FittedLine& line : scan.lines) {
    const double y = line.row * scan.pitch;
    ASSERT_LT(i, points.size());
    EXPECT_NEAR(points[i].x(), line.begin, 1e-12);
    for (;; ++i) {
      ASSERT_LT(i, points.size());
      ASSERT_NEAR(points[i].y(), y, 1e-12);
      ASSERT_NEAR(points[i].z(), part.jet(points[i].x(), y).z, 1e-8);  // the spline's error: some nanometres
      if (points[i].x() >= line.end - 1e-12) break;
      ASSERT_LT(i + 1, points.size());
      ASSERT_GT(points[i + 1].x(), points[i].x());
      // The parameter runs along x: on the part's steepest slope a step is longer than its share of x.
      EXPECT_LE((points[i + 1] - points[i]).norm(), 1.5 * spacing);
      EXPECT_GE(points[i + 1].x() - points[i].x(), 0.5 * spacing) << "no more of them than needed";
    }
    ++i;
  }
  EXPECT_EQ(i, points.size());
}

}  // namespace
}  // namespace scan_to_path::toolpath
