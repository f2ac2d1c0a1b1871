// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/scallop_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/geometry/worlds.h"
#include "scan_to_path/process/cutting.h"
#include "scan_to_path/toolpath/contact_frame.h"
#include "scan_to_path/toolpath/scallop.h"
#include "scan_to_path/verification/path_deviation.h"
#include "support/expect_input_error.h"
#include "support/fitted_scans.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

namespace scan_to_path::verification {
namespace {

constexpr double radius = 0.02;
constexpr double h = 1e-4;
constexpr double limit = 1e-3;

std::vector<SurfacePoint> planePoints(double x_min, double x_max, double y_min, double y_max) {
  std::vector<SurfacePoint> points;
  for (double x = x_min; x <= x_max; x += 0.0037) {
    for (double y = y_min; y <= y_max; y += 2.5e-5) points.push_back({{x, y, 0.0}, Vector3::UnitZ()});
  }
  return points;
}

/// The S part's points seen along a grid that is turned with the rows: fine across them.
std::vector<SurfacePoint> sPartPoints(double direction, double from_edge) {
  SampleGrid grid;
  grid.T_surface_grid = geometry::makeFrame({0.12, 0.08, 0.1}, {0.0, 0.0, direction});
  grid.x_min = grid.y_min = -0.15;
  grid.x_max = grid.y_max = 0.15;
  grid.spacing_x = 1.31e-2;
  grid.spacing_y = 1e-4;
  std::vector<SurfacePoint> points;
  for (const SurfacePoint& p : sampleSurface(geometry::SPart(), grid)) {
    const double edge = std::min({p.point.x(), 0.24 - p.point.x(), p.point.y(), 0.16 - p.point.y()});
    if (edge >= from_edge) points.push_back(p);
  }
  return points;
}

toolpath::ToolPath plannedSPart(double direction, double ball_radius = radius) {
  process::CuttingOptions options;
  options.direction = direction;
  options.ball_radius = ball_radius;
  const auto scan = test::fittedSPart();
  return process::makeCuttingPlanner(options)->plan({&scan, "base_link"}, {}).path;
}

TEST(ScallopCheck, FindsThePlanesCusps) {
  for (const double pitch : {0.002, 0.004, 0.006}) {
    const auto report =
        checkScallops(test::planeRows(5, pitch, 0.1, 7), radius, planePoints(0.0, 0.1, 0.0, 4.0 * pitch), limit);
    EXPECT_EQ(report.uncut, 0U);
    // The cusp lies on a grid point to 1.3e-5 m and falls by pitch / (2 r) beside it.
    EXPECT_NEAR(report.highest, toolpath::scallopHeight(pitch, radius, 0.0), 1.3e-5 * pitch / (2.0 * radius) + 1e-12);
    EXPECT_LT(report.deepest_cut, 1e-12);
    // A parabola's mean is a third of its height, its median a quarter.
    EXPECT_NEAR(report.mean / report.highest, 1.0 / 3.0, 0.01);
    EXPECT_NEAR(report.median / report.highest, 1.0 / 4.0, 0.02);
    EXPECT_NEAR(report.percentile_95 / report.highest, 0.95 * 0.95, 0.02);
  }
}

TEST(ScallopCheck, FindsTheExactRulesCuspsOnACylinder) {
  const double rho = 0.1;
  const double L = toolpath::rowDistance(h, radius, 1.0 / rho);
  toolpath::ToolPath path = test::planeRows(3, 0.0, 0.05, 4);
  for (int row = 0; row < 3; ++row) {
    for (auto& waypoint : path.segments[static_cast<std::size_t>(row)].waypoints) {
      const double angle = row * L / rho;
      const Vector3 n(std::cos(angle), std::sin(angle), 0.0);  // the cylinder's axis is z
      waypoint.pose =
          toolpath::contactFrame(rho * n + waypoint.pose.translation().x() * Vector3::UnitZ(), n, Vector3::UnitZ());
    }
  }
  std::vector<SurfacePoint> points;
  const geometry::Cylinder cylinder(rho);
  for (int i = 0; i <= 2000; ++i) {
    const double angle = 2.0 * L / rho * i / 2000.0;
    points.push_back(cylinder.closestPoint({std::cos(angle), std::sin(angle), 0.021}));
  }
  EXPECT_NEAR(checkScallops(path, radius, points, limit).highest, h, 1e-11);
}

TEST(ScallopCheck, AgreesWithBruteForce) {
  Random random(1);
  toolpath::ToolPath path = test::planeRows(3, 0.005, 0.03, 3);
  for (auto& segment : path.segments) {
    for (auto& waypoint : segment.waypoints)
      waypoint.pose =
          waypoint.pose * geometry::makeFrame(test::randomVector(random, 3e-4), test::randomVector(random, 0.02));
  }
  for (int i = 0; i < 100; ++i) {
    const Vector3 q(random.uniform(0.002, 0.028), random.uniform(0.0, 0.01), 0.0);
    const auto report = checkScallops(path, radius, {{q, Vector3::UnitZ()}}, limit);
    double lowest = limit;  // the lowest place over q that any ball along any move covers
    for (const auto& segment : path.segments) {
      for (std::size_t k = 1; k < segment.waypoints.size(); ++k) {
        const Vector3 a = segment.waypoints[k - 1].pose * Vector3(0, 0, radius);
        const Vector3 b = segment.waypoints[k].pose * Vector3(0, 0, radius);
        for (int j = 0; j <= 1000; ++j) {
          const Vector3 d = a + (b - a) * (j / 1000.0) - q;
          const double aside2 = radius * radius - d.x() * d.x() - d.y() * d.y();
          if (aside2 > 0.0) lowest = std::min(lowest, d.z() - std::sqrt(aside2));
        }
      }
    }
    // Steps of 1e-5 m along a move miss the lowest place by (5e-6)^2 / (2 r).
    EXPECT_NEAR(report.heights[0], lowest, 1e-9);
  }
}

TEST(ScallopCheck, SeesTooMuchAndTooLittle) {
  const toolpath::ToolPath path = test::planeRows(5, 0.004, 0.1, 7);
  const auto points = planePoints(0.0, 0.1, 0.0, 0.016);
  const geometry::Frame lower(Eigen::Translation3d(0.0, 0.0, -1e-5));
  EXPECT_NEAR(checkScallops(test::moved(path, lower), radius, points, limit).deepest_cut, 1e-5, 1e-12);
  toolpath::ToolPath dropped = path;
  dropped.segments.erase(dropped.segments.begin() + 2);
  EXPECT_GT(checkScallops(dropped, radius, points, limit).highest, 3.9e-4);  // twice the pitch, four times h
  EXPECT_GT(checkScallops(dropped, radius, points, 2e-4).uncut, 0U);
  toolpath::ToolPath air = path;
  for (auto& waypoint : air.segments[2].waypoints) waypoint.process_on = false;
  EXPECT_GT(checkScallops(air, radius, points, limit).highest, 3.9e-4);
}

TEST(ScallopCheck, IsTheSameForAnyNumberOfThreadsAndWhereverThePartIs) {
  Random random(2);
  const auto T = test::randomFrame(random);
  const toolpath::ToolPath path = test::planeRows(5, 0.004, 0.1, 7);
  auto points = planePoints(0.0, 0.1, 0.0, 0.016);
  const auto one = checkScallops(path, radius, points, limit, 1);
  EXPECT_EQ(one.heights, checkScallops(path, radius, points, limit, 3).heights);
  for (SurfacePoint& p : points) p = {T * p.point, T.linear() * p.normal};
  EXPECT_NEAR(checkScallops(test::moved(path, T), radius, points, limit).highest, one.highest, 1e-11);
}

TEST(ScallopCheck, OnTheSPartKeepsTheBarInAnyDirection) {
  for (const double degrees : {0.0, 20.0, 45.0, 70.0, 90.0, 110.0, 135.0, 160.0}) {
    const double direction = degrees * M_PI / 180.0;
    // Rows that end at a slanted edge leave more than h in the strip up to one pitch inside it.
    const double from_edge = degrees == 0.0 || degrees == 90.0 ? 6e-4 : 5e-3;
    const auto report = checkScallops(plannedSPart(direction), radius, sPartPoints(direction, from_edge), limit);
    EXPECT_GT(report.points, 10000U);
    EXPECT_EQ(report.uncut, 0U) << degrees;
    EXPECT_LE(report.highest, h) << degrees << " at " << report.highest_at.transpose();
    EXPECT_GE(report.highest, 0.85 * h) << degrees;
    EXPECT_LE(report.deepest_cut, 6.5e-6) << degrees;  // chords: 5 um, a little more where the bend across adds to it
  }
}

TEST(ScallopCheck, OnTheSPartFailsTheBarWithARowDropped) {
  toolpath::ToolPath path = plannedSPart(0.0);
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    if (path.segments[i].name == "row_20") path.segments.erase(path.segments.begin() + static_cast<std::ptrdiff_t>(i));
  }
  EXPECT_GT(checkScallops(path, radius, sPartPoints(0.0, 6e-4), limit).highest, 3.0 * h);
}

TEST(ScallopCheck, OnTheSPartFailsTheBarWithAnotherBall) {
  // Rows planned for a larger ball are too far apart for the smaller one.
  EXPECT_GT(checkScallops(plannedSPart(0.0, 0.025), radius, sPartPoints(0.0, 6e-4), limit).highest, 1.05 * h);
}

TEST(ScallopCheck, WithNoiseStaysWithinTheScallopAndThePathsError) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    toolpath::ToolPath path = plannedSPart(0.0);
    for (auto& segment : path.segments) {
      for (auto& waypoint : segment.waypoints) waypoint.pose.translation().z() += 5e-6 * random.gaussian();
    }
    const auto deviation = measureDeviation(path, geometry::SPart());
    EXPECT_GT(deviation.rms, 4e-6);
    const auto report = checkScallops(path, radius, sPartPoints(0.0, 6e-4), limit);
    EXPECT_LE(report.highest, h + deviation.largest);
    EXPECT_GT(report.highest, h);  // twin: without the error's allowance the bar is broken
  }
}

TEST(ScallopCheck, SamplesWhatTheRaysHit) {
  SampleGrid grid;
  grid.T_surface_grid = geometry::makeFrame({0.0, 0.0, 1.0}, {0.0, 0.0, 0.0});
  grid.x_min = -0.01;
  grid.x_max = 0.25;
  grid.y_max = 0.1;
  grid.spacing_x = grid.spacing_y = 0.01;
  const auto points = sampleSurface(geometry::SPart(), grid);
  EXPECT_GE(points.size(), 24U * 11U);
  EXPECT_LE(points.size(), 25U * 11U);
  for (const SurfacePoint& p : points)
    EXPECT_NEAR(p.point.z(), geometry::SPart().jet(p.point.x(), p.point.y()).z, 1e-9);
}

TEST(ScallopCheck, RejectsBadArguments) {
  const toolpath::ToolPath path = test::planeRows(1, 0.0, 0.1, 1);
  test::expectInputError([&] { checkScallops(path, 0.0, {}, limit); }, "ball radius");
  test::expectInputError([&] { checkScallops(path, radius, {}, 0.0); }, "limit");
  test::expectInputError([&] { checkScallops({}, radius, {}, limit); }, "no move of the path works");
  test::expectInputError([&] { sampleSurface(geometry::SPart(), {{}, 0, 1, 0, 1, 0.0, 1.0}); }, "spacing");
}

}  // namespace
}  // namespace scan_to_path::verification
