// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/scan_line_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_input_error.h"
#include "support/fitted_scans.h"
#include "support/surface_oracle.h"

namespace scan_to_path::process {
namespace {

CuttingOptions onLines() {
  CuttingOptions options;
  options.row_source = RowSource::scan_lines;
  return options;
}

TEST(ScanLineRows, LieOnTheLinesWithTheSurfacesNormals) {
  Random random(1);
  const geometry::SPart part;
  const RowPlan plan = scanLineRows(test::fittedSPart(test::randomFrame(random)), onLines());
  ASSERT_EQ(plan.rows.size(), 41U);
  for (const Row& row : plan.rows) {
    EXPECT_NEAR(row.points.front().t, 5e-4, 6e-5);  // 0.5 mm along a line that rises by up to 0.55
    EXPECT_NEAR(row.points.back().t, 0.2395, 6e-5);
    for (const RowPoint& p : row.points) {
      EXPECT_NEAR(p.point.y(), 0.004 * row.row, 1e-12);
      EXPECT_NEAR(p.point.z(), part.jet(p.point.x(), p.point.y()).z, 1e-8);
      EXPECT_LT(geometry::angleBetween(p.normal, part.at(p.point.x(), p.point.y()).normal), 0.1 * M_PI / 180.0);
    }
  }
}

TEST(ScanLineRows, TakeTheNormalsAskedFor) {
  const geometry::SPart part;
  const auto scan = test::fittedSPart();
  const auto worst = [&](scan::NormalMode mode) {
    CuttingOptions options = onLines();
    options.normals = mode;
    double angle = 0.0;
    for (const Row& row : scanLineRows(scan, options).rows) {
      for (const RowPoint& p : row.points) {
        angle = std::max(angle, geometry::angleBetween(p.normal, part.at(p.point.x(), p.point.y()).normal));
      }
    }
    return angle;
  };
  EXPECT_LT(worst(scan::NormalMode::surface), 1e-5);
  // Differences across err by about the third derivative times L^2 / 6 on the border; the seed's rule by more.
  EXPECT_LT(worst(scan::NormalMode::weighted), 2e-3);
  EXPECT_GT(worst(scan::NormalMode::seed), 1.1 * worst(scan::NormalMode::weighted));
}

/// Farthest of the points half way between waypoints from their chord, at `offset` along the normals [m].
double widestSag(const std::vector<Row>& rows, double offset) {
  const geometry::SPart part;
  double widest = 0.0;
  for (const Row& row : rows) {
    for (std::size_t i = 1; i < row.points.size(); ++i) {
      const RowPoint& a = row.points[i - 1];
      const RowPoint& b = row.points[i];
      const auto middle = part.at(0.5 * (a.t + b.t), a.point.y());
      const Vector3 p = a.point + offset * a.normal;
      const Vector3 along = (b.point + offset * b.normal - p).normalized();
      const Vector3 off = middle.point + offset * middle.normal - p;
      widest = std::max(widest, (off - along * along.dot(off)).norm());
    }
  }
  return widest;
}

TEST(ScanLineRows, KeepTheChordToleranceOfContactAndBallCentre) {
  auto options = onLines();
  options.normals = scan::NormalMode::surface;  // exact here: an error of the normal would move the ball's centre too
  std::vector<Row> rows = scanLineRows(test::fittedSPart(), options).rows;
  for (const double offset : {0.0, options.ball_radius}) {
    EXPECT_LE(widestSag(rows, offset), options.chord_tolerance) << offset;
  }
  for (Row& row : rows) row.points.erase(row.points.begin() + static_cast<std::ptrdiff_t>(row.points.size() / 4));
  EXPECT_GT(widestSag(rows, 0.0), options.chord_tolerance);  // twin: a waypoint of each row is missing
}

TEST(ScanLineRows, StretchesOfARowAreItsPieces) {
  auto scan = test::fittedSPart();
  auto& whole = scan.lines[20];
  scan::FittedLine second = whole;
  whole.end = 0.1;
  whole.ends_at_edge = false;
  second.begin = 0.15;
  second.begins_at_edge = false;
  scan.lines.insert(scan.lines.begin() + 21, second);
  const RowPlan plan = scanLineRows(scan, onLines());
  ASSERT_EQ(plan.rows.size(), 42U);
  EXPECT_EQ(plan.rows[20].pieces, 2);
  EXPECT_EQ(plan.rows[21].piece, 1);
  EXPECT_NEAR(plan.rows[20].points.back().t, 0.1, 1e-12);  // no margin at a cut inside the part
  EXPECT_NEAR(plan.rows[21].points.front().t, 0.15, 1e-12);
  EXPECT_EQ(plan.distances.size(), 40U);
}

TEST(ScanLineRows, TellTheScallopThatTheScansPitchLeaves) {
  const geometry::Rectangle area = {0.0, 0.1, 0.0, 0.06};
  const auto scan = test::fittedScan([](double, double) { return 0.0; }, area, 0.004, 8, 8);
  const RowPlan plan = scanLineRows(scan, onLines());
  EXPECT_NEAR(plan.widest_scallop, 0.02 - std::sqrt(0.02 * 0.02 - 0.002 * 0.002), 1e-9);
  for (const double distance : plan.distances) EXPECT_NEAR(distance, 0.004, 1e-12);
}

TEST(ScanLineRows, RejectScansWithoutALineLongEnough) {
  auto scan = test::fittedSPart();
  CuttingOptions options = onLines();
  options.edge_margin = 0.2;
  test::expectInputError([&] { scanLineRows(scan, options); }, "none of 41 fitted lines");
  options = onLines();
  options.ball_radius = 0.001;
  test::expectInputError([&] { scanLineRows(scan, options); }, "rows 0 and 1 are so far apart that a ball");
}

}  // namespace
}  // namespace scan_to_path::process
