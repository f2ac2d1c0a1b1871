// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/gouge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/toolpath/ball_tool.h"
#include "scan_to_path/toolpath/contact_frame.h"
#include "support/expect_input_error.h"
#include "support/fitted_scans.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

namespace scan_to_path::toolpath {
namespace {

constexpr double radius = 0.02;
constexpr double tolerance = 2e-5;
const geometry::Rectangle area = {-0.06, 0.06, -0.06, 0.06};

/// A hollow or convex round of signed radius rho along y, tangent to the plane z = 0 at x = 0.
test::Height channel(double rho) {
  return [rho](double x, double) { return -rho * (1.0 - std::sqrt(1.0 - x * x / (rho * rho))); };
}

/// A plane with a smooth step of the given height about x = 0.03.
test::Height wall(double height) {
  return [height](double x, double) { return 0.5 * height * (1.0 + std::tanh((x - 0.03) / 0.003)); };
}

/// One row of contacts on z = f(x, 0) from x_begin to x_end.
ToolPath rowOn(const scan::FittedScan& scan, double x_begin, double x_end, int moves, double above = 0.0) {
  const ScanSurface surface(scan.surface);
  ToolPath path = test::planeRows(1, 0.0, 1.0, moves);
  for (int i = 0; i <= moves; ++i) {
    const double x = x_begin + (x_end - x_begin) * i / moves;
    const auto jet = surface.jet(x, 0.0);
    const Vector3 n = normalOf(jet);
    path.segments[0].waypoints[static_cast<std::size_t>(i)].pose =
        scan.T_cloud_scan * contactFrame(Vector3(x, 0.0, jet.z) + above * n, n, {1.0, 0.0, jet.zx});
  }
  return path;
}

/// Distance of the ball's centre from the surface by brute force over a fine grid, less the radius.
double clearanceByBruteForce(const test::Height& f, const Vector3& centre) {
  double least = std::numeric_limits<double>::infinity();
  for (double x = area.x_min; x <= area.x_max; x += 1e-5) {
    least = std::min(least, std::hypot(x - centre.x(), f(x, 0.0) - centre.z()));
  }
  return least - radius;
}

TEST(Gouge, IsNoneOnTheSPart) {
  const auto scan = test::fittedSPart();
  const GougeCheck check(scan, radius, tolerance);
  EXPECT_TRUE(check.check(rowOn(scan, 0.0, 0.24, 200)).empty());
}

TEST(Gouge, AHollowTighterThanTheBallIsFoundWithItsRadius) {
  const auto scan = test::fittedScan(channel(-0.08), area, 0.004, 60, 20);
  EXPECT_TRUE(GougeCheck(scan, 0.075, tolerance).check(rowOn(scan, -0.02, 0.02, 20)).empty());
  const auto gouges = GougeCheck(scan, 0.085, tolerance).check(rowOn(scan, -0.02, 0.02, 20));
  ASSERT_EQ(gouges.size(), 21U);
  for (const auto& gouge : gouges) {
    EXPECT_EQ(gouge.verdict, Verdict::gouge);
    EXPECT_EQ(gouge.unit, "m");
    // The interpolating surface's curvature is good to 1e-3 of 12.5 1/m here.
    EXPECT_NEAR(gouge.margin, -0.005, 1e-4);
    EXPECT_NE(gouge.reason.find("hollow with a radius of"), std::string::npos) << gouge.reason;
    EXPECT_NE(gouge.remedy.find("use a ball smaller than"), std::string::npos);
  }
}

TEST(Gouge, ADistantWallInTheBallIsFoundWhereBruteForceFindsIt) {
  const auto f = wall(0.015);
  const auto scan = test::fittedScan(f, area, 0.004, 200, 12);
  const ToolPath path = rowOn(scan, -0.03, 0.025, 110);
  const auto gouges = GougeCheck(scan, radius, tolerance).check(path);
  std::vector<bool> is_found(111, false);
  for (const auto& gouge : gouges) is_found[static_cast<std::size_t>(gouge.index)] = true;
  int deep = 0;
  for (std::size_t i = 0; i < 111; ++i) {
    const double clearance = clearanceByBruteForce(f, ballCentre(path.segments[0].waypoints[i].pose, radius));
    EXPECT_TRUE(is_found[i] || clearance > -2.0 * tolerance) << i << " " << clearance;
    EXPECT_TRUE(!is_found[i] || clearance < -0.5 * tolerance) << i << " " << clearance;
    deep += clearance < -1e-4 ? 1 : 0;
  }
  EXPECT_GT(deep, 10);
  EXPECT_GT(110 - static_cast<int>(gouges.size()), 30);
}

TEST(Gouge, TheMarginOfADistantWallIsTheBallsDepth) {
  const auto f = wall(0.015);
  const auto scan = test::fittedScan(f, area, 0.004, 200, 12);
  const ToolPath path = rowOn(scan, 0.0, 0.018, 60);
  int compared = 0;
  for (const auto& gouge : GougeCheck(scan, radius, tolerance).check(path)) {
    if (gouge.reason.find("the ball goes") == std::string::npos) continue;
    const auto& waypoint = path.segments[0].waypoints[static_cast<std::size_t>(gouge.index)];
    // The grid of the oracle misses the nearest point by up to 5 um along the surface; the fit is good to 10 um here.
    EXPECT_NEAR(gouge.margin, clearanceByBruteForce(f, ballCentre(waypoint.pose, radius)), 2e-5);
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST(Gouge, AHalvedWallIsNotFoundAsDeep) {
  // The twin of the test above: a check that looked at the wrong surface would not notice the wall's height.
  const auto low = test::fittedScan(wall(0.0005), area, 0.004, 200, 12);
  const auto high = test::fittedScan(wall(0.015), area, 0.004, 200, 12);
  const ToolPath path = rowOn(high, 0.0, 0.018, 60);
  EXPECT_LT(GougeCheck(low, radius, tolerance).check(path).size(),
            GougeCheck(high, radius, tolerance).check(path).size());
}

TEST(Gouge, MovesWithTheScan) {
  Random random(3);
  const auto f = wall(0.015);
  const auto still = test::fittedScan(f, area, 0.004, 100, 12);
  const auto moved = test::fittedScan(f, area, 0.004, 100, 12, test::randomFrame(random));
  const auto a = GougeCheck(still, radius, tolerance).check(rowOn(still, -0.03, 0.025, 60));
  const auto b = GougeCheck(moved, radius, tolerance).check(rowOn(moved, -0.03, 0.025, 60));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].index, b[i].index);
    EXPECT_NEAR(a[i].margin, b[i].margin, 1e-9);
  }
}

TEST(Gouge, StockLeftOnTheSurfaceCountsAsSurface) {
  const auto scan = test::fittedScan(channel(-0.08), area, 0.004, 60, 20);
  const GougeCheck check(scan, 0.03, tolerance);
  EXPECT_TRUE(check.check(rowOn(scan, -0.02, 0.02, 10, 0.045), {0.045}).empty());
  const auto gouges = check.check(rowOn(scan, -0.02, 0.02, 10, 0.055), {0.055});  // 0.03 + 0.055 > 0.08
  EXPECT_EQ(gouges.size(), 11U);
}

TEST(Gouge, HolesHoldNothing) {
  auto scan = test::fittedScan(wall(0.015), area, 0.004, 100, 12);
  const ToolPath path = rowOn(scan, 0.005, 0.015, 10);
  EXPECT_FALSE(GougeCheck(scan, radius, tolerance).check(path).empty());
  scan.outline.polygons.push_back({{0.02, -0.05}, {0.02, 0.05}, {0.055, 0.05}, {0.055, -0.05}});
  EXPECT_TRUE(GougeCheck(scan, radius, tolerance).check(path).empty());
}

TEST(Gouge, LinksAreCheckedToo) {
  const auto scan = test::fittedScan(wall(0.03), area, 0.004, 100, 12);
  ToolPath path = rowOn(scan, -0.05, -0.03, 4);
  Segment link = {"link_0_1", {path.segments[0].waypoints[0]}};
  link.waypoints[0].process_on = false;
  link.waypoints[0].pose.translation() = Vector3(0.05, 0.0, 0.01);  // inside the step
  path.segments.push_back(link);
  const auto gouges = GougeCheck(scan, radius, tolerance).check(path);
  ASSERT_EQ(gouges.size(), 1U);
  EXPECT_EQ(gouges[0].segment, 1);
}

TEST(Gouge, MovesInTheAirAreSwept) {
  const auto ridge = [](double x, double) { return 0.02 * std::exp(-x * x / (0.006 * 0.006)); };
  const auto scan = test::fittedScan(ridge, area, 0.004, 200, 12);
  const auto crossing = [&](double height) {
    ToolPath path = rowOn(scan, -0.05, -0.045, 1);
    Segment link = {"link_0_1", std::vector<Waypoint>(2, path.segments[0].waypoints[0])};
    link.waypoints[0].pose.translation() = Vector3(-0.045, 0.0, height);
    link.waypoints[1].pose.translation() = Vector3(0.045, 0.0, height);
    for (auto& waypoint : link.waypoints) waypoint.process_on = false;
    path.segments.push_back(link);
    return path;
  };
  const auto gouges = GougeCheck(scan, radius, tolerance).check(crossing(0.018));
  ASSERT_EQ(gouges.size(), 1U);
  EXPECT_EQ(gouges[0].segment, 1);
  EXPECT_EQ(gouges[0].index, 1);  // where the move leads to
  EXPECT_NE(gouges[0].reason.find("on the move to it the ball goes"), std::string::npos) << gouges[0].reason;
  EXPECT_TRUE(GougeCheck(scan, radius, tolerance).check(crossing(0.0205)).empty());
}

TEST(Gouge, MovesFromContactToContactAreSwept) {
  // A boss 4 mm high and 2 mm wide beside the row, its top half way between two contacts 5 mm apart: the ball is 0.2 mm
  // in it there and free of it at both.
  const auto f = [](double x, double y) {
    return 0.004 * std::exp(-(x * x + std::pow(y - 0.0056, 2)) / (0.001 * 0.001));
  };
  constexpr double small = 0.006;
  const geometry::Rectangle around = {-0.012, 0.012, -0.008, 0.014};
  const auto scan = test::fittedScan(f, around, 0.0005, 96, 88);
  ToolPath path = test::planeRows(1, 0.0, 1.0, 3);
  const auto place = [&](double x) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3 contact(x + 0.005 * static_cast<double>(i) - 0.01, 0.0, 0.0);
      path.segments[0].waypoints[i].pose =
          scan.T_cloud_scan * contactFrame(contact, Vector3::UnitZ(), Vector3::UnitX());
    }
  };
  const auto depth = [&](double x) {
    double nearest = 1.0;
    for (double u = -0.003; u <= 0.003; u += 2e-5) {
      for (double v = 0.004; v <= 0.014; v += 2e-5) {
        nearest = std::min(nearest, std::hypot(std::hypot(u - x, v), f(u, v) - small));
      }
    }
    return small - nearest;
  };
  place(0.0025);  // contacts at -7.5, -2.5, 2.5 and 7.5 mm
  ASSERT_GT(depth(0.0), 1e-4);
  ASSERT_LT(depth(0.0025), 0.0);
  const auto gouges = GougeCheck(scan, small, tolerance).check(path);
  ASSERT_EQ(gouges.size(), 1U);
  EXPECT_EQ(gouges[0].index, 2);  // where the move leads to
  EXPECT_NE(gouges[0].reason.find("on the move to it the ball goes"), std::string::npos) << gouges[0].reason;
  // Steps of a sixteenth of the radius miss the deepest place by a 32nd: (r / 32)^2 / 2r = 3 um; the fit is good to 10
  // um.
  EXPECT_NEAR(-gouges[0].margin, depth(0.0), 2e-5);
  // What straight moves may leave the surface by is not held against them.
  EXPECT_TRUE(GougeCheck(scan, small, tolerance).check(path, {}, 1.1 * depth(0.0)).empty());
}

// A smooth surface cuts a fold's corner; the lines show the wall behind it.
TEST(Gouge, LinesThatLeaveTheSurfaceCount) {
  const auto f = wall(0.015);
  auto scan = test::fittedScan([](double, double) { return 0.0; }, area, 0.004, 200, 12);
  const ToolPath path = rowOn(scan, -0.03, 0.025, 110);
  EXPECT_TRUE(GougeCheck(scan, radius, tolerance, GougeTarget::surface_and_lines).check(path).empty());
  scan.lines = test::fittedScan(f, area, 0.004, 200, 12).lines;
  EXPECT_TRUE(GougeCheck(scan, radius, tolerance).check(path).empty());
  std::vector<bool> is_found(111, false);
  for (const auto& gouge : GougeCheck(scan, radius, tolerance, GougeTarget::surface_and_lines).check(path)) {
    is_found[static_cast<std::size_t>(gouge.index)] = true;
    const auto& waypoint = path.segments[0].waypoints[static_cast<std::size_t>(gouge.index)];
    // Points on the lines are 0.3 mm apart, which leaves 1 um, and the lines are good to 10 um here.
    EXPECT_NEAR(gouge.margin, clearanceByBruteForce(f, ballCentre(waypoint.pose, radius)), 2e-5);
  }
  for (std::size_t i = 0; i < 111; ++i) {
    const double clearance = clearanceByBruteForce(f, ballCentre(path.segments[0].waypoints[i].pose, radius));
    EXPECT_TRUE(is_found[i] || clearance > -2.0 * tolerance) << i << " " << clearance;
    EXPECT_TRUE(!is_found[i] || clearance < -0.5 * tolerance) << i << " " << clearance;
  }
}

// A wall that is no part of the fit, and a post of which nobody knows how high it is.
TEST(Gouge, WhatStandsBesideTheFitCounts) {
  auto scan = test::fittedScan([](double, double) { return 0.0; }, area, 0.004, 60, 12);
  const ToolPath path = rowOn(scan, -0.03, 0.03, 60);
  const GougeCheck bare(scan, radius, tolerance);
  EXPECT_TRUE(bare.check(path).empty());
  for (const double height : {0.005, 0.5}) {
    auto with_wall = scan;
    for (int i = -40; i <= 40; ++i) with_wall.obstacles.emplace_back(0.03F, 0.0005F * i, static_cast<float>(height));
    const auto gouges = GougeCheck(with_wall, radius, tolerance).check(path);
    const double reach = height < radius ? std::sqrt(radius * radius - std::pow(radius - height, 2)) : radius;
    std::size_t expected = 0;
    for (const auto& waypoint : path.segments[0].waypoints) expected += waypoint.pose.translation().x() > 0.03 - reach;
    EXPECT_NEAR(static_cast<double>(gouges.size()), static_cast<double>(expected), 1.0) << height;
    ASSERT_FALSE(gouges.empty());
    EXPECT_NEAR(gouges.back().margin, height < radius ? -height : -radius, 1e-6) << height;  // right below or inside it
    EXPECT_NE(gouges.back().reason.find("into what stands there beside the fit"), std::string::npos);
  }
}

TEST(Gouge, RejectsBadArguments) {
  const auto scan = test::fittedSPart();
  test::expectInputError([&] { GougeCheck(scan, 0.0, tolerance); }, "ball radius");
  test::expectInputError([&] { GougeCheck(scan, 1e-6, tolerance); }, "larger for a part of this extent");
  test::expectInputError([&] { GougeCheck(scan, radius, -1.0); }, "tolerance");
  test::expectInputError(
      [&] {
        GougeCheck(scan, radius, tolerance).check(rowOn(scan, 0.1, 0.2, 2), {0.0, 0.0});
      },
      "number of allowances is 2");
}

}  // namespace
}  // namespace scan_to_path::toolpath
