// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scan_to_path/process/cutting.h"
#include "scan_to_path/toolpath/contact_frame.h"
#include "scan_to_path/toolpath/scallop.h"
#include "support/expect_input_error.h"
#include "support/flat_plate.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

/// What a user chooses of a part's rows: a region, rows that are skipped, rows that are turned round.
namespace scan_to_path::process {
namespace {

using geometry::Frame;
using toolpath::Segment;

constexpr double file_rounding = 1e-9;  // what path files keep [m]
const std::vector<Eigen::Vector2d> triangle = {{0.013, 0.011}, {0.083, 0.021}, {0.033, 0.052}};

PlannedPath planChosen(const scan::FittedScan& scan, const CuttingOptions& options,
                       const Frame& T_input_workobject = Frame::Identity()) {
  return makeCuttingPlanner(options)->plan({&scan, "base_link", T_input_workobject}, {});
}

CuttingOptions from(RowSource source) {
  CuttingOptions options;
  options.row_source = source;
  return options;
}

/// The contacts of each row or piece of a row, by name.
std::map<std::string, std::vector<toolpath::Waypoint>> contacts(const PlannedPath& plan) {
  std::map<std::string, std::vector<toolpath::Waypoint>> rows;
  for (const Segment& segment : plan.path.segments) {
    if (!toolpath::isRow(segment)) continue;
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      if (toolpath::isContact(segment, i)) rows[segment.name].push_back(segment.waypoints[i]);
    }
  }
  return rows;
}

std::vector<std::string> names(const PlannedPath& plan) {
  std::vector<std::string> names;
  for (const Segment& segment : plan.path.segments) {
    if (toolpath::isRow(segment)) names.push_back(segment.name);
  }
  return names;
}

/// Where the line y crosses the triangle.
std::pair<double, double> acrossTriangle(double y) {
  double first = 1.0;
  double last = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = triangle[i];
    const auto& b = triangle[(i + 1) % 3];
    if ((a.y() < y) == (b.y() < y)) continue;
    const double x = a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y());
    first = std::min(first, x);
    last = std::max(last, x);
  }
  return {first, last};
}

TEST(Region, RowsEndOnItsBorder) {
  for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
    auto options = from(source);
    const auto whole = contacts(planChosen(test::flatPlate(), options));
    options.region = triangle;
    const PlannedPath plan = planChosen(test::flatPlate(), options);
    const auto rows = contacts(plan);
    EXPECT_TRUE(plan.findings.empty());
    std::size_t expected = 0;
    for (const auto& [name, points] : whole) {
      const double y = points.front().pose.translation().y();
      const auto [first, last] = acrossTriangle(y);
      if (last - first < 1e-4) continue;
      ++expected;
      ASSERT_EQ(rows.count(name), 1U) << name << " at " << y;
      const auto& row = rows.at(name);
      const auto [a, b] = std::minmax({row.front().pose.translation().x(), row.back().pose.translation().x()});
      EXPECT_NEAR(a, first, file_rounding) << name;
      EXPECT_NEAR(b, last, file_rounding) << name;
      for (const auto& waypoint : row) EXPECT_NEAR(waypoint.pose.translation().y(), y, file_rounding);
    }
    EXPECT_GT(expected, 5U);
    EXPECT_EQ(rows.size(), expected);
    EXPECT_EQ(test::figureOf(plan, "rows")->value, static_cast<double>(expected));
    // Twin: the whole path has contacts outside.
    EXPECT_GT(whole.size(), rows.size());
  }
}

TEST(Region, OfEverythingIsTheSameBytes) {
  for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
    auto options = from(source);
    options.direction = source == RowSource::surface ? 0.3 : 0.0;
    const auto scan = test::fittedSPart();
    const PlannedPath all = planChosen(scan, options);
    options.region = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    const PlannedPath chosen = planChosen(scan, options);
    EXPECT_TRUE(toolpath::formatToolPath(chosen.path) == toolpath::formatToolPath(all.path));
    EXPECT_NEAR(test::figureOf(chosen, "scallop")->value, test::figureOf(all, "scallop")->value, 1e-15);
    options.region[1].x() = options.region[2].x() = 0.1;  // twin
    EXPECT_FALSE(toolpath::formatToolPath(planChosen(scan, options).path) == toolpath::formatToolPath(all.path));
  }
}

TEST(Region, MovesWithThePart) {
  Random random(11);
  for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
    const auto T = test::randomFrame(random);
    auto options = from(source);
    options.region = {{0.05, 0.03}, {0.2, 0.05}, {0.1, 0.13}};
    const PlannedPath still = planChosen(test::fittedSPart(), options);
    const PlannedPath moved = planChosen(test::fittedSPart(T), options, T);
    // Rounding at coordinates of a metre, enlarged by the normals' differences across 4 mm.
    EXPECT_LT(test::largestDifference(moved.path, test::moved(still.path, T)), 1e-9);
  }
}

TEST(Region, RowsAreThePiecesOfTheWholePartsRows) {
  const auto scan = test::fittedSPart();
  CuttingOptions options;
  const auto whole = contacts(planChosen(scan, options));
  // A fork with two prongs along y: rows across it are two pieces each.
  options.region = {{0.05, 0.02}, {0.2, 0.02}, {0.2, 0.14}, {0.15, 0.14},
                    {0.15, 0.05}, {0.1, 0.05}, {0.1, 0.14}, {0.05, 0.14}};
  const auto rows = contacts(planChosen(scan, options));
  int split = 0;
  for (const auto& [name, points] : rows) {
    const std::string row = name.substr(0, name.find('_', 4));
    ASSERT_EQ(whole.count(row), 1U);
    EXPECT_NEAR(points[0].pose.translation().y(), whole.at(row)[0].pose.translation().y(), file_rounding);
    const bool is_split = name != row;
    split += is_split ? 1 : 0;
    EXPECT_EQ(is_split, points[0].pose.translation().y() > 0.05) << name;
  }
  EXPECT_GT(split, 20);
  EXPECT_EQ(split % 2, 0);
}

TEST(Region, DoesNotHideWhatTheBallTouchesOutside) {
  // A wall of 60 degrees beside the region: the ball touches it while its contact is in the region.
  const auto wall = [](double x, double) { return 0.01 / (1.0 + std::exp(-(x - 0.06) / 0.001)); };
  const auto scan = test::fittedScan(wall, test::flat_area, 0.004, 400, 8);
  CuttingOptions options;
  options.region = {{0.0, 0.0}, {0.054, 0.0}, {0.054, 0.06}, {0.0, 0.06}};
  const PlannedPath near = planChosen(scan, options);
  EXPECT_FALSE(near.findings.empty());
  options.region[1].x() = options.region[2].x() = 0.03;
  EXPECT_TRUE(planChosen(scan, options).findings.empty());
}

TEST(Region, RefusesWhatHoldsNoRow) {
  for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
    auto options = from(source);
    options.region = {{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}};
    test::expectInputError([&] { planChosen(test::flatPlate(), options); }, "cutting: no row lies in path.region");
    options.region = {{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}};
    test::expectInputError([&] { makeCuttingPlanner(options); }, "path.region: sides 0 and 2 meet");
    options.region = {{0.0, 0.0}, {1.0, 1000.0}, {1.0, 0.0}};
    test::expectInputError([&] { makeCuttingPlanner(options); }, "path.region[1][1] is 1000 m, must be in [-100, 100]");
  }
}

TEST(SkippedRows, AreLeftOutOfEveryPass) {
  for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
    auto options = from(source);
    options.stock = 0.002;
    const auto whole = contacts(planChosen(test::flatPlate(), options));
    options.skip_rows = "0, 3-4";
    const PlannedPath plan = planChosen(test::flatPlate(), options);
    const auto rows = contacts(plan);
    EXPECT_EQ(plan.passes, 2);
    EXPECT_EQ(rows.size() + 2 * 3, whole.size());
    for (const char* row : {"row_0", "row_3", "row_4"}) {
      for (const char* pass : {"pass_0_", "pass_1_"}) EXPECT_EQ(rows.count(std::string(pass) + row), 0U) << row;
    }
    for (const auto& [name, points] : rows) {
      ASSERT_EQ(points.size(), whole.at(name).size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(points[i].pose.matrix(), whole.at(name)[i].pose.matrix()) << name;
      }
    }
  }
}

TEST(SkippedRows, AreNoNeighbours) {
  auto options = from(RowSource::scan_lines);
  const double scallop = toolpath::scallopHeight(0.004, options.ball_radius, 0.0);
  options.skip_rows = "2";
  const PlannedPath plan = planChosen(test::flatPlate(), options);
  EXPECT_NEAR(test::figureOf(plan, "scallop")->value, scallop, 1e-9);
  EXPECT_NEAR(test::figureOf(plan, "row_distance_max")->value, 0.004, 1e-12);
  // Where every second row is skipped nothing is known of a scallop, and nothing is said of it.
  options.skip_rows = "1, 3, 5, 7, 9, 11, 13, 15";
  const PlannedPath sparse = planChosen(test::flatPlate(), options);
  EXPECT_EQ(test::figureOf(sparse, "rows")->value, 8.0);
  EXPECT_EQ(test::figureOf(sparse, "scallop"), nullptr);
  EXPECT_EQ(test::figureOf(sparse, "row_distance_max"), nullptr);
}

TEST(SkippedRows, MustBeThereAndLeaveSome) {
  for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
    auto options = from(source);
    options.skip_rows = "all";
    test::expectInputError([&] { planChosen(test::flatPlate(), options); }, "path.skip_rows is \"all\": none of");
    options.skip_rows = "3-99";
    test::expectInputError([&] { planChosen(test::flatPlate(), options); },
                           "path.skip_rows names row 99, the part's last one is");
    options.skip_rows = "";
    options.reverse_rows = "77";
    test::expectInputError([&] { planChosen(test::flatPlate(), options); }, "path.reverse_rows names row 77");
    options.reverse_rows = "one";
    test::expectInputError([&] { makeCuttingPlanner(options); }, "path.reverse_rows: \"one\" is neither a number");
  }
}

TEST(ReversedRows, AreDrivenTheOtherWayRound) {
  for (const RowOrder order : {RowOrder::zig_zag, RowOrder::one_way}) {
    CuttingOptions options;
    options.row_order = order;
    auto scan = test::flatPlate();
    scan.outline.polygons.push_back({{0.04, 0.02}, {0.04, 0.04}, {0.06, 0.04}, {0.06, 0.02}});
    const PlannedPath usual = planChosen(scan, options);
    options.reverse_rows = "1, 6";
    const PlannedPath turned = planChosen(scan, options);
    const auto before = contacts(usual);
    const auto after = contacts(turned);
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [name, points] : after) {
      const bool is_turned = name == "row_1" || name.rfind("row_6_", 0) == 0;
      const auto& was = before.at(name);
      ASSERT_EQ(points.size(), was.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& there = was[is_turned ? was.size() - 1 - i : i].pose;
        EXPECT_LT((points[i].pose.translation() - there.translation()).norm(), file_rounding) << name;
        EXPECT_NEAR(points[i].pose.linear().col(0).dot(there.linear().col(0)), is_turned ? -1.0 : 1.0, 1e-9) << name;
      }
    }
    const auto at = [](const std::vector<std::string>& list, const char* name) {
      return std::find(list.begin(), list.end(), name) - list.begin();
    };
    EXPECT_LT(at(names(usual), "row_6_0"), at(names(usual), "row_6_1"));
    EXPECT_LT(at(names(turned), "row_6_1"), at(names(turned), "row_6_0"));
  }
}

}  // namespace
}  // namespace scan_to_path::process
