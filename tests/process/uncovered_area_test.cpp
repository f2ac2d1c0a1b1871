// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/uncovered_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scan_to_path/process/cutting.h"
#include "support/flat_plate.h"
#include "support/surface_oracle.h"

namespace scan_to_path::process {
namespace {

constexpr double grid_spacing = 4e-4;  // [m]; 60 cm^2 at 40000 points are 0.39 mm, and finer

PlannedPath planWhole(const scan::FittedScan& scan, const CuttingOptions& options) {
  return makeCuttingPlanner(options)->plan({&scan, "base_link", scan.T_cloud_scan}, {});
}

double figureIn(const PlannedPath& plan, const std::string& name) {
  const Figure* found = test::figureOf(plan, name);
  return found == nullptr ? std::nan("") : found->value;
}

CuttingOptions alongLines() {
  CuttingOptions options;
  options.row_source = RowSource::scan_lines;
  return options;
}

/// What rows on lines 4 mm apart may leave: twice what they do on a plane.
double heightOfLines(double radius) { return 2.0 * (radius - std::sqrt(radius * radius - 0.002 * 0.002)); }

/// How far beside its row a ball leaves the height h on a plane.
double reach(double radius, double h) { return std::sqrt(2.0 * radius * h - h * h); }

TEST(UncoveredArea, IsNothingWhereRowsFollowTheScallop) {
  for (const RowSource source : {RowSource::surface, RowSource::scan_lines}) {
    CuttingOptions options;
    options.row_source = source;
    EXPECT_EQ(figureIn(planWhole(test::flatPlate(), options), "uncovered_area"), 0.0);
    EXPECT_EQ(figureIn(planWhole(test::fittedSPart(), options), "uncovered_area"), 0.0);
  }
}

TEST(UncoveredArea, IsTheStripOfASkippedRow) {
  Random random(2);
  auto options = alongLines();
  options.skip_rows = "7";
  for (const auto& T : {geometry::Frame::Identity(), test::randomFrame(random)}) {
    const PlannedPath plan = planWhole(test::flatPlate(T), options);
    // Rows 8 mm apart, of which balls take 2.8 mm on each side.
    const double h = heightOfLines(options.ball_radius);
    const double strip = 0.1 * (0.008 - 2.0 * reach(options.ball_radius, h));
    // The strip's two long sides are as fine as the grid.
    EXPECT_NEAR(figureIn(plan, "uncovered_area"), strip, 0.1 * grid_spacing);
    EXPECT_NEAR(figureIn(plan, "uncovered_share"), strip / 0.006, 0.1 * grid_spacing / 0.006);
  }
}

TEST(UncoveredArea, IsWhatLiesOutsideTheRegion) {
  auto options = alongLines();
  options.region = {{-1.0, -1.0}, {0.06, -1.0}, {0.06, 1.0}, {-1.0, 1.0}};
  const PlannedPath plan = planWhole(test::flatPlate(), options);
  // At a row's end the ball reaches further by as much as beside it, half way between the rows not at all.
  const double h = heightOfLines(options.ball_radius);
  EXPECT_LT(figureIn(plan, "uncovered_area"), 0.04 * 0.06 + 0.06 * grid_spacing);
  EXPECT_GT(figureIn(plan, "uncovered_area"), (0.04 - reach(options.ball_radius, h)) * 0.06 - 0.06 * grid_spacing);
}

TEST(UncoveredArea, CountsTheLastPassOnly) {
  auto options = alongLines();
  options.stock = 0.002;
  const auto scan = test::flatPlate();
  PlannedPath plan = planWhole(scan, options);
  ASSERT_EQ(plan.passes, 2);
  EXPECT_EQ(figureIn(plan, "uncovered_area"), 0.0);
  const auto last = std::find_if(plan.path.segments.begin(), plan.path.segments.end(),
                                 [](const auto& segment) { return segment.name == "pass_1_row_0"; });
  plan.allowances.resize(static_cast<std::size_t>(last - plan.path.segments.begin()));
  plan.path.segments.erase(last, plan.path.segments.end());
  EXPECT_EQ(uncoveredArea(plan.path, plan.allowances, scan, options.ball_radius, 1e-4).share, 1.0);
}

}  // namespace
}  // namespace scan_to_path::process
