// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/surface_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "scan_to_path/process/row_scallop.h"
#include "scan_to_path/toolpath/scallop.h"
#include "scan_to_path/toolpath/scan_surface.h"
#include "support/expect_input_error.h"
#include "support/fitted_scans.h"

namespace scan_to_path::process {
namespace {

constexpr double degree = M_PI / 180.0;
const geometry::Rectangle area = {0.0, 0.1, 0.0, 0.06};

scan::FittedScan plane() {
  return test::fittedScan([](double, double) { return 0.01; }, area, 0.004, 8, 8);
}

Eigen::Vector2d across(double direction) { return {-std::sin(direction), std::cos(direction)}; }

TEST(SurfaceRows, OnAPlaneAreAsFarApartAsTheRuleSays) {
  CuttingOptions options;
  const RowPlan plan = surfaceRows(plane(), options);
  const double rule = toolpath::rowDistance(options.scallop_height, options.ball_radius, 0.0);
  // 93 to 99.5 % of h, whose square roots these are; the last step is what is left.
  for (std::size_t i = 0; i + 1 < plan.distances.size(); ++i) {
    EXPECT_GE(plan.distances[i], std::sqrt(0.93) * rule);
    EXPECT_LE(plan.distances[i], std::sqrt(0.995) * rule * (1.0 + 1e-6));
  }
  EXPECT_LE(plan.widest_scallop, options.scallop_height);
  EXPECT_GE(plan.widest_scallop, 0.93 * options.scallop_height);
}

TEST(SurfaceRows, ReachFromEdgeToEdgeLessTheMargin) {
  CuttingOptions options;
  options.edge_margin = 0.002;
  const RowPlan plan = surfaceRows(plane(), options);
  EXPECT_NEAR(plan.rows.front().points.front().point.y(), 0.002, 2e-7);
  EXPECT_NEAR(plan.rows.back().points.front().point.y(), 0.058, 2e-7);
  for (const Row& row : plan.rows) {
    EXPECT_NEAR(row.points.front().point.x(), 0.002, 2e-5);  // the corner's disc at the very edge
    EXPECT_NEAR(row.points.back().point.x(), 0.098, 2e-5);
  }
}

// 59 mm, less the margins, at 1e-7 m are 590000 rows: minutes and gigabytes.
TEST(SurfaceRows, TooManyAreRefusedUpFront) {
  CuttingOptions options;
  options.pitch = 1e-7;
  test::expectInputError([&] { surfaceRows(plane(), options); }, "path.pitch of 0.100 um: number of rows is ");
  test::expectInputError([&] { surfaceRows(plane(), options); }, "must be at most 10000");
  options.pitch = 0.0;
  options.ball_radius = 1e-4;
  options.scallop_height = 1e-8;  // planes 2 sqrt(2 r h) = 2.8 um apart: 20900 rows
  test::expectInputError([&] { surfaceRows(plane(), options); }, "path.scallop_height of 0.010 um");
}

TEST(SurfaceRows, DoNotBreakUpAlongAMeasuredEdge) {
  // An edge that is 6 um off straight, as drift makes it: a row right at it would be half as long.
  auto scan = plane();
  scan.outline.polygons = {{{0.0, 0.0}, {0.05, -3e-6}, {0.05, 3e-6}, {0.1, 3e-6}, {0.1, 0.06}, {0.0, 0.06}}};
  const CuttingOptions options;
  const RowPlan plan = surfaceRows(scan, options);
  EXPECT_LT(plan.rows.front().points.front().point.x(), options.edge_margin + 1e-4);
  EXPECT_GT(plan.rows.front().points.back().point.x(), 0.1 - options.edge_margin - 1e-4);
  EXPECT_LT(plan.rows.front().points.front().point.y(), options.edge_margin + 1.5e-4);
}

TEST(SurfaceRows, TakeAnyDirectionAndStayInside) {
  const auto scan = test::fittedSPart();
  const toolpath::ScanSurface surface(scan.surface);
  for (int angle = 0; angle < 180; angle += 15) {
    CuttingOptions options;
    options.direction = angle * degree;
    const RowPlan plan = surfaceRows(scan, options);
    EXPECT_LE(plan.widest_scallop, options.scallop_height) << angle;
    EXPECT_GE(plan.widest_scallop, 0.9 * options.scallop_height) << angle;
    for (const Row& row : plan.rows) {
      const double s = across(options.direction).dot(row.points.front().point.head<2>());
      for (const RowPoint& p : row.points) {
        const double edge = std::min({p.point.x(), 0.24 - p.point.x(), p.point.y(), 0.16 - p.point.y()});
        ASSERT_GE(edge, options.edge_margin - 1e-12) << angle;
        ASSERT_NEAR(across(options.direction).dot(p.point.head<2>()), s, 1e-12);
        ASSERT_EQ(p.point.z(), surface.height(p.point.x(), p.point.y()));
      }
    }
  }
}

TEST(SurfaceRows, OppositeDirectionIsTheSameRowsBackwards) {
  CuttingOptions options;
  options.pitch =
      0.0029500001;  // 59 mm between the edges in 20 steps and a rounding, so both ways give the same planes
  CuttingOptions opposite = options;
  opposite.direction = 180.0 * degree;
  const auto scan = test::fittedScan([](double x, double y) { return x * y; }, area, 0.004, 8, 8);
  const RowPlan there = surfaceRows(scan, options);
  const RowPlan back = surfaceRows(scan, opposite);
  ASSERT_EQ(there.rows.size(), back.rows.size());
  for (std::size_t i = 0; i < there.rows.size(); ++i) {
    const Row& a = there.rows[i];
    const Row& b = back.rows[back.rows.size() - 1 - i];
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t k = 0; k < a.points.size(); ++k) {
      // Edges are found to 1e-7, and the corner's disc makes rows there that much shorter by its square root.
      EXPECT_LT((a.points[k].point - b.points[b.points.size() - 1 - k].point).norm(), 2e-5);
      EXPECT_LT((a.points[k].tangent + b.points[b.points.size() - 1 - k].tangent).norm(), 1e-3);
    }
  }
}

/// Farthest of the surface from the moves between waypoints, at quarters of them [m].
double widestChordError(const RowPlan& plan, const scan::FittedScan& scan) {
  const toolpath::ScanSurface surface(scan.surface);
  double widest = 0.0;
  for (const Row& row : plan.rows) {
    for (std::size_t i = 1; i < row.points.size(); ++i) {
      const RowPoint& a = row.points[i - 1];
      const RowPoint& b = row.points[i];
      for (const double share : {0.25, 0.5, 0.75}) {
        const Vector3 p = a.point + share * (b.point - a.point);
        const auto jet = surface.jet(p.x(), p.y());
        widest = std::max(widest, std::abs(p.z() - jet.z) / std::sqrt(1.0 + jet.zx * jet.zx));
      }
    }
  }
  return widest;
}

TEST(SurfaceRows, KeepTheChordTolerance) {
  const auto scan = test::fittedSPart();
  CuttingOptions options;
  RowPlan plan = surfaceRows(scan, options);
  for (const Row& row : plan.rows) {
    for (std::size_t i = 1; i < row.points.size(); ++i) {
      EXPECT_LE((row.points[i].point - row.points[i - 1].point).norm(), options.max_spacing * (1.0 + 1e-3));
    }
  }
  const double widest = widestChordError(plan, scan);
  EXPECT_LE(widest, options.chord_tolerance);
  EXPECT_GE(widest, 0.5 * options.chord_tolerance);  // else there are too many waypoints
  EXPECT_LT(plan.rows.front().points.size(), 250U);
  for (Row& row : plan.rows) row.points.erase(row.points.begin() + static_cast<std::ptrdiff_t>(row.points.size() / 4));
  EXPECT_GT(widestChordError(plan, scan), options.chord_tolerance);  // twin: a waypoint of each row is missing
}

TEST(SurfaceRows, AHoleSplitsThem) {
  auto scan = plane();
  scan.outline.polygons.push_back({{0.04, 0.02}, {0.04, 0.04}, {0.06, 0.04}, {0.06, 0.02}});
  CuttingOptions options;
  const RowPlan plan = surfaceRows(scan, options);
  int split = 0;
  for (const Row& row : plan.rows) {
    for (const RowPoint& p : row.points) {
      const bool in_hole =
          p.point.x() > 0.0395 + 1e-9 && p.point.x() < 0.0605 - 1e-9 && p.point.y() > 0.02 && p.point.y() < 0.04;
      ASSERT_FALSE(in_hole) << p.point.transpose();
    }
    split += row.pieces == 2 ? 1 : 0;
  }
  // 21 mm of hole and margin hold five or six rows of two pieces each.
  EXPECT_GE(split, 10);
  EXPECT_LE(split, 12);
}

TEST(SurfaceRows, FollowAGivenPitch) {
  CuttingOptions options;
  options.pitch = 0.007;
  const RowPlan plan = surfaceRows(plane(), options);
  ASSERT_EQ(plan.distances.size(), 9U);  // 59 mm
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(plan.distances[i], 0.007, 1e-15);
  EXPECT_NEAR(plan.distances.back(), 0.003, 1e-6);
  EXPECT_NEAR(plan.widest_scallop, toolpath::scallopHeight(0.007, 0.02, 0.0), 1e-9);
}

TEST(SurfaceRows, AreNearerOnSlopesAcross) {
  const double slope = 0.5;
  const auto scan = test::fittedScan([=](double, double y) { return slope * y; }, area, 0.004, 8, 8);
  const RowPlan tilted = surfaceRows(scan, {});
  const RowPlan flat = surfaceRows(plane(), {});
  // Planes are L cos(slope) apart; both aim at the same share of h.
  EXPECT_NEAR(tilted.distances[2] / flat.distances[2], std::cos(std::atan(slope)), 1e-3);
}

TEST(SurfaceRows, RejectAnOutlineThatTheMarginEats) {
  CuttingOptions options;
  options.edge_margin = 0.031;
  test::expectInputError([&] { surfaceRows(plane(), options); }, "no row fits into the part's outline");
  options = {};
  options.pitch = 0.041;
  test::expectInputError([&] { surfaceRows(plane(), options); }, "rows 0 and 1 are so far apart that a ball");
  scan::FittedScan scan = plane();
  scan.outline.polygons.clear();
  test::expectInputError([&] { surfaceRows(scan, {}); }, "no polygon");
}

/// A star-shaped polygon over the S part with 3 to 8 corners, in the order of their angles.
std::vector<Eigen::Vector2d> randomPolygon(Random& random) {
  const int corners = 3 + static_cast<int>(random.uniform(0.0, 6.0));
  const Eigen::Vector2d centre(random.uniform(0.06, 0.18), random.uniform(0.05, 0.11));
  std::vector<Eigen::Vector2d> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * (i + random.uniform(0.0, 0.8)) / corners;
    polygon.push_back(centre + random.uniform(0.02, 0.12) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

/// The widest scallop at the waypoints that are driven.
double widestAtOwnWaypoints(const RowPlan& plan, const scan::FittedScan& scan, double ball_radius) {
  const toolpath::ScanSurface surface(scan.surface);
  double widest = 0.0;
  for (const Row& a : plan.rows) {
    for (const Row& b : plan.rows) {
      if (b.row == a.row + 1) widest = std::max(widest, widestScallop(a, b, surface, ball_radius).value_or(0.0));
    }
  }
  return widest;
}

// Rows that are cut get waypoints of their own, whose chords lie elsewhere within the chord tolerance; that does not
// make rows too far apart that were placed on the whole part's waypoints.
TEST(SurfaceRows, KeepTheScallopHeightInAnyRegion) {
  const auto scan = test::fittedSPart();
  CuttingOptions options;
  options.chord_tolerance = 3e-5;  // coarse, so that chords tell
  const double whole = surfaceRows(scan, options).widest_scallop;
  Random random(5);
  int over = 0;
  for (int i = 0; i < 30; ++i) {
    const auto polygon = randomPolygon(random);
    const RowPlan plan = surfaceRows(scan, options, {}, toolpath::Region(polygon, geometry::Frame::Identity()));
    EXPECT_LE(plan.widest_scallop, whole) << i;
    EXPECT_GT(plan.widest_scallop, 0.5 * options.scallop_height) << i;
    const double own = widestAtOwnWaypoints(plan, scan, options.ball_radius);
    EXPECT_LE(own, options.scallop_height + options.chord_tolerance) << i;
    over += own > whole ? 1 : 0;
  }
  EXPECT_GT(over, 0);  // twin: judged at their own waypoints, some leave more than the whole part's rows do anywhere
}

TEST(SurfaceRows, StopWhenAsked) {
  const std::atomic<bool> cancelled = true;
  EXPECT_THROW(surfaceRows(plane(), {}, Progress({}, &cancelled)), Interrupted);
}

}  // namespace
}  // namespace scan_to_path::process
