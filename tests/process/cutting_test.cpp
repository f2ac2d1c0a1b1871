// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/cutting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/toolpath/ball_tool.h"
#include "scan_to_path/toolpath/contact_frame.h"
#include "support/expect_input_error.h"
#include "support/fitted_scans.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

namespace scan_to_path::process {
namespace {

using toolpath::Segment;

const geometry::Rectangle plate = {0.0, 0.1, 0.0, 0.06};

scan::FittedScan platePlane() {
  return test::fittedScan([](double, double) { return 0.01; }, plate, 0.004, 8, 8);
}

PlannedPath planned(const scan::FittedScan& scan, const CuttingOptions& options = {}) {
  return makeCuttingPlanner(options)->plan({&scan, "base_link"}, {});
}

double figure(const PlannedPath& plan, const std::string& name) {
  for (const Figure& f : plan.figures) {
    if (f.name == name) return f.value;
  }
  ADD_FAILURE() << "no figure " << name;
  return std::nan("");
}

std::vector<Segment> rowsOf(const PlannedPath& plan) {
  std::vector<Segment> rows;
  for (const Segment& segment : plan.path.segments) {
    if (toolpath::isRow(segment)) rows.push_back(segment);
  }
  return rows;
}

TEST(Cutting, PlansTheSPartWithoutFindings) {
  for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
    CuttingOptions options;
    options.row_source = source;
    const auto scan = test::fittedSPart();
    const PlannedPath plan = planned(scan, options);
    EXPECT_EQ(plan.path.process, "cutting");
    EXPECT_EQ(plan.path.frame, "base_link");
    EXPECT_TRUE(plan.findings.empty());
    EXPECT_EQ(plan.path.segments.front().name, "approach");
    EXPECT_EQ(plan.path.segments.back().name, "retract");
    for (const Segment& row : rowsOf(plan)) {
      EXPECT_GE(row.waypoints.size(), 60U);
      EXPECT_LE(row.waypoints.size(), 250U);
    }
    EXPECT_EQ(figure(plan, "gouges"), 0.0);
    EXPECT_EQ(figure(plan, "rows"), static_cast<double>(rowsOf(plan).size()));
    EXPECT_EQ(figure(plan, "waypoints"), static_cast<double>(toolpath::waypointCount(plan.path)));
  }
}

TEST(Cutting, MovesWithTheScan) {
  Random random(7);
  for (int i = 0; i < 3; ++i) {
    const auto T = test::randomFrame(random);
    for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
      CuttingOptions options;
      options.row_source = source;
      options.lead = 0.1;
      const PlannedPath still = planned(test::fittedSPart(), options);
      const PlannedPath moved = planned(test::fittedSPart(T), options);
      // Rounding at coordinates of a metre, enlarged by the normals' differences across 4 mm.
      EXPECT_LT(test::largestDifference(moved.path, test::moved(still.path, T)), 1e-9);
    }
  }
}

TEST(Cutting, ZigZagTurnsEveryOtherRowRound) {
  CuttingOptions options;
  const auto to_and_fro = rowsOf(planned(platePlane(), options));
  options.row_order = RowOrder::one_way;
  const auto one_way = rowsOf(planned(platePlane(), options));
  ASSERT_EQ(to_and_fro.size(), one_way.size());
  for (std::size_t i = 0; i < one_way.size(); ++i) {
    EXPECT_GT(one_way[i].waypoints[2].pose.linear()(0, 0), 0.99);
    EXPECT_GT((i % 2 == 0 ? 1.0 : -1.0) * to_and_fro[i].waypoints[2].pose.linear()(0, 0), 0.99);
  }
}

TEST(Cutting, AWaypointsXAxisPointsToTheNextOne) {
  for (const Segment& row : rowsOf(planned(test::fittedSPart()))) {
    for (std::size_t i = 1; i + 2 < row.waypoints.size(); ++i) {
      const auto& pose = row.waypoints[i].pose;
      const geometry::Vector3 chord = row.waypoints[i + 1].pose.translation() - pose.translation();
      // A chord of 5 mm over a bend of 14 1/m turns by 2 degrees from the tangent.
      EXPECT_LT(geometry::angleBetween(pose.linear().col(0), chord), 0.036);
    }
  }
}

TEST(Cutting, HasOneConstantToolFrame) {
  CuttingOptions options;
  options.lead = 0.2;
  options.tilt = -0.1;
  const PlannedPath plan = planned(platePlane(), options);
  const scan::Frame tool = geometry::snapped(toolpath::ballToolFrame({0.02, 0.2, -0.1}));
  EXPECT_EQ((plan.path.T_contact_tcp.matrix() - tool.matrix()).norm(), 0.0);
}

TEST(Cutting, TakesTheStockOffInConstantSteps) {
  CuttingOptions options;
  options.stock = 0.003;
  options.depth_of_cut = 0.001;
  const PlannedPath plan = planned(platePlane(), options);
  const auto rows = rowsOf(plan);
  const std::size_t per_pass = rows.size() / 3;
  ASSERT_EQ(rows.size() % 3, 0U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double above = 0.001 * static_cast<double>(2 - i / per_pass);
    for (std::size_t k = 1; k + 1 < rows[i].waypoints.size(); ++k) {
      EXPECT_NEAR(rows[i].waypoints[k].pose.translation().z(), 0.01 + above, 1e-12);
    }
  }
  EXPECT_EQ(rows.front().name, "pass_0_row_0");
  EXPECT_EQ(rows[per_pass].name, "pass_1_row_0");
  EXPECT_TRUE(plan.findings.empty());
}

TEST(Cutting, NoPassTakesMoreThanTheDepthOfCut) {
  CuttingOptions options;
  options.stock = 0.0025;
  options.depth_of_cut = 0.001;
  const auto rows = rowsOf(planned(platePlane(), options));
  EXPECT_EQ(rows.back().name.substr(0, 7), "pass_2_");
  EXPECT_NEAR(rows.front().waypoints[3].pose.translation().z(), 0.01 + 0.0025 * 2.0 / 3.0, 1e-12);
}

// The part is a plane, so the stock's top is one too. What is driven at rapid feed leads from one waypoint of the links
// to the next, or off a row that has just been cut.
TEST(Cutting, MovesAtRapidFeedKeepAboveTheStock) {
  constexpr double height_of_plate = 0.01;
  for (const double stock : {0.0, 0.004, 0.03}) {
    CuttingOptions options;
    options.stock = stock;
    options.depth_of_cut = 0.015;
    for (const Segment& segment : planned(platePlane(), options).path.segments) {
      if (toolpath::isRow(segment)) {
        EXPECT_EQ(segment.waypoints.front().feed, options.links.plunge_feed) << segment.name;
        continue;
      }
      for (const auto& waypoint : segment.waypoints) {
        EXPECT_GT(waypoint.pose.translation().z(), height_of_plate + stock + 0.004) << segment.name << ", " << stock;
      }
    }
  }
}

TEST(Cutting, KeepsAndReportsGouges) {
  // A groove whose bottom has a radius of 6 mm, under a ball of 20 mm and one of 4 mm.
  const auto groove = [](double x, double) { return -0.012 * std::exp(-std::pow((x - 0.05) / 0.012, 2)); };
  const auto scan = test::fittedScan(groove, plate, 0.004, 200, 8);
  const PlannedPath plan = planned(scan);
  EXPECT_GT(plan.findings.size(), 100U);
  EXPECT_EQ(figure(plan, "gouges"), static_cast<double>(plan.findings.size()));
  for (std::size_t i = 1; i < plan.findings.size(); ++i) {
    const auto& a = plan.findings[i - 1];
    const auto& b = plan.findings[i];
    EXPECT_TRUE(a.segment < b.segment || (a.segment == b.segment && a.index < b.index));
  }
  CuttingOptions smaller;
  smaller.ball_radius = 0.004;
  EXPECT_TRUE(planned(scan, smaller).findings.empty());
}

TEST(Cutting, AHolesRowsAreNamedByPiece) {
  auto scan = platePlane();
  scan.outline.polygons.push_back({{0.04, 0.02}, {0.04, 0.04}, {0.06, 0.04}, {0.06, 0.02}});
  std::vector<std::string> names;
  for (const Segment& row : rowsOf(planned(scan))) names.push_back(row.name);
  EXPECT_NE(std::find(names.begin(), names.end(), "row_0"), names.end());
  const auto first = std::find(names.begin(), names.end(), "row_6_0");
  const auto second = std::find(names.begin(), names.end(), "row_7_1");
  ASSERT_NE(first, names.end());
  EXPECT_EQ(*(first + 1), "row_6_1");
  ASSERT_NE(second, names.end());
  EXPECT_EQ(*(second + 1), "row_7_0");  // driven backwards
}

TEST(Cutting, SumsUpTheTravel) {
  CuttingOptions options;
  options.leads.length = 0.0;
  const PlannedPath plan = planned(platePlane(), options);
  EXPECT_NEAR(figure(plan, "cutting_length"), 0.099 * figure(plan, "rows"), 1e-4);
  EXPECT_GT(figure(plan, "path_length"), figure(plan, "cutting_length"));
  EXPECT_GT(figure(plan, "time"), figure(plan, "cutting_length") / options.feed);
  EXPECT_LE(figure(plan, "row_distance_min"), figure(plan, "row_distance_median"));
  EXPECT_LE(figure(plan, "row_distance_median"), figure(plan, "row_distance_max"));
}

// A post between the rows' ends, higher than any contact.
TEST(Cutting, LinksKeepTheirClearanceOverObstacles) {
  auto scan = platePlane();
  const auto highest = [&scan] {
    double z = -1.0;
    for (const Segment& segment : planned(scan).path.segments) {
      for (const auto& waypoint : segment.waypoints) z = std::max(z, waypoint.pose.translation().z());
    }
    return z;
  };
  const double before = highest();
  const auto contact = planned(scan).path.segments[1].waypoints.back().pose.translation();
  const geometry::Vector3 top = contact + geometry::Vector3(0.0, 0.0, 0.08);
  const geometry::Vector3 post = scan.T_cloud_scan.inverse() * top;
  scan.obstacles.push_back(post.cast<float>());
  EXPECT_NEAR(highest(), contact.z() + 0.08 + CuttingOptions().links.clearance, 1e-6);
  EXPECT_LT(before, contact.z() + 0.08);
}

TEST(Cutting, GivesTheSameBytesTwice) {
  const auto scan = test::fittedSPart();
  EXPECT_EQ(toolpath::formatToolPath(planned(scan).path), toolpath::formatToolPath(planned(scan).path));
}

TEST(Cutting, RejectsBadOptionsAndInput) {
  const auto rejects = [](auto&& change, const std::string& part) {
    CuttingOptions options;
    change(options);
    test::expectInputError([&] { makeCuttingPlanner(options); }, part);
  };
  rejects([](auto& o) { o.ball_radius = 0.0; }, "path.ball_radius is 0 m, must be in [0.0001, 1]");
  rejects([](auto& o) { o.feed = std::nan(""); }, "path.feed");
  rejects([](auto& o) { o.scallop_height = 0.03; }, "path.scallop_height is 0.03 m, must be below the ball radius");
  rejects([](auto& o) { o.leads.length = -1.0; }, "path.leads.length");
  rejects([](auto& o) { o.links.clearance = 0.0; }, "path.links.clearance");
  rejects([](auto& o) { o.depth_of_cut = 0.0; }, "path.depth_of_cut");
  rejects([](auto& o) { o.depth_of_cut = o.stock = 0.021; }, "path.depth_of_cut is 0.021 m, must be at most the ball");
  test::expectInputError([] { makeCuttingPlanner({})->plan({}, {}); }, "needs a fitted scan");
}

}  // namespace
}  // namespace scan_to_path::process
