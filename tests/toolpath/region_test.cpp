// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"
#include "support/surface_oracle.h"

namespace scan_to_path::toolpath {
namespace {

using Eigen::Vector2d;
using RegionCorners = std::vector<Vector2d>;

constexpr double to_the_bit = 1e-14;  // some sums of numbers of about 1

const RegionCorners upright = {{0.2, 0.0}, {0.8, 0.0}, {0.8, 1.0}, {0.2, 1.0}};

std::vector<double> evenly(double first, double last, int count) {
  std::vector<double> values;
  for (int i = 0; i <= count; ++i) values.push_back(first + (last - first) * i / count);
  return values;
}

/// Star-shaped round the origin, hollow corners included.
RegionCorners starRegion(Random& random) {
  RegionCorners corners;
  for (int i = 0; i < 13; ++i) {
    const double angle = 2.0 * M_PI * i / 13.0;
    corners.push_back(random.uniform(0.3, 1.0) * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

/// By the winding of angles: the oracle.
bool windsRound(const RegionCorners& polygon, const Vector2d& p) {
  double turn = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d u = polygon[i] - p;
    const Vector2d v = polygon[(i + 1) % polygon.size()] - p;
    turn += std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
  }
  return std::abs(turn) > M_PI;
}

TEST(Region, WithoutCornersIsEverything) {
  const Region region;
  EXPECT_TRUE(region.isEverything());
  EXPECT_TRUE(region.contains({1e9, -1e9, 0.0}));
  const auto stretches = region.inside([](double t) { return Vector3(t, 0.0, 0.0); }, {0.0, 1.0});
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_EQ(stretches[0].end, 1.0);
}

TEST(Region, IsThePolygonsInsideInAnyFrame) {
  Random random(3);
  for (int round = 0; round < 30; ++round) {
    const RegionCorners polygon = starRegion(random);
    const Frame T = test::randomFrame(random);
    const Region region(polygon, T);
    for (int i = 0; i < 100; ++i) {
      const Vector2d p(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      const Vector3 asked = T.inverse() * Vector3(p.x(), p.y(), random.uniform(-5.0, 5.0));
      EXPECT_EQ(region.contains(asked), windsRound(polygon, p)) << round << ": " << p.transpose();
    }
  }
}

TEST(Region, CutsLinesWhereTheyLeaveIt) {
  const Region region(upright, Frame::Identity());
  const auto line = [](double t) { return Vector3(t, 0.5, 7.0); };
  const auto stretches = region.inside(line, evenly(0.0, 1.0, 3));
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_NEAR(stretches[0].begin, 0.2, to_the_bit);
  EXPECT_NEAR(stretches[0].end, 0.8, to_the_bit);
  EXPECT_TRUE(region.inside(line, evenly(0.81, 1.0, 3)).empty());
  // Inside all the way, and with a border's line crossed outside the border: not a bit is lost.
  const auto along = evenly(0.1, 0.9, 3);
  const auto whole = region.inside([](double t) { return Vector3(0.5, t, 0.0); }, along);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].begin, along.front());
  EXPECT_EQ(whole[0].end, along.back());
}

TEST(Region, FindsTheBorderOnTheCurveNotOnItsChords) {
  const Region region(upright, Frame::Identity());
  // A circle's arc of radius 1: x = cos t is 0.8 and 0.2 at known angles; its chords sag by 1 %.
  const auto arc = [](double t) { return Vector3(std::cos(t), std::sin(t), 0.0); };
  const auto stretches = region.inside(arc, evenly(0.0, 0.5 * M_PI, 5));
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_NEAR(stretches[0].begin, std::acos(0.8), to_the_bit);
  EXPECT_NEAR(stretches[0].end, std::acos(0.2), to_the_bit);
}

TEST(Region, IsSeenAlongItsOwnZ) {
  // Leaning by 30 degrees about y: a point h up is seen h sin(30 deg) further.
  const Frame T = geometry::makeFrame(Vector3::Zero(), Vector3(0.0, M_PI / 6.0, 0.0));
  const auto line = [](double t) { return Vector3(t, 0.5, 0.1); };
  const auto stretches = Region(upright, T).inside(line, evenly(-1.0, 1.0, 4));
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_NEAR(stretches[0].begin, (0.2 - 0.05) / std::cos(M_PI / 6.0), to_the_bit);
  EXPECT_NEAR(stretches[0].end, (0.8 - 0.05) / std::cos(M_PI / 6.0), to_the_bit);
}

TEST(Region, StretchesAreThePointsInside) {
  Random random(5);
  for (int round = 0; round < 50; ++round) {
    const RegionCorners polygon = starRegion(random);
    const double s = random.uniform(-1.0, 1.0);
    const auto line = [&](double t) { return Vector3(t, s, 0.0); };
    const auto stretches = Region(polygon, Frame::Identity()).inside(line, evenly(-1.1, 1.1, 4));
    for (int i = 0; i < 100; ++i) {
      const double t = random.uniform(-1.1, 1.1);
      bool is_inside = false;
      for (const auto& stretch : stretches) is_inside |= t > stretch.begin && t < stretch.end;
      EXPECT_EQ(is_inside, windsRound(polygon, {t, s})) << round << ": " << t << " " << s;
    }
  }
}

TEST(Region, MustBoundSomething) {
  const auto rejects = [](const RegionCorners& polygon, const std::string& part) {
    test::expectInputError([&] { validateRegion(polygon, "path.region"); }, part);
  };
  EXPECT_NO_THROW(validateRegion({}, "path.region"));
  EXPECT_NO_THROW(validateRegion(upright, "path.region"));
  EXPECT_NO_THROW(validateRegion({upright.rbegin(), upright.rend()}, "path.region"));
  rejects({{0, 0}, {1, 1}}, "path.region has 2 corners, must have 3 at least or none");
  rejects({{0, 0}, {1, 0}, {1, std::nan("")}}, "path.region[2] is not finite");
  rejects({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, "path.region: corner 2 is the one before");
  rejects({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "path.region: sides 0 and 2 meet");          // a bow tie
  rejects({{0, 0}, {2, 0}, {1, 0}, {1, 1}}, "path.region: side 1 runs back");            // a spike
  rejects({{0, 0}, {1, 0}, {2, 0}}, "path.region: side 2 runs back");                    // flat
  rejects({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}, "path.region: sides 0 and 2 meet");  // touches itself
}

}  // namespace
}  // namespace scan_to_path::toolpath
