// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/row_neighbours.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/fitted_scans.h"

namespace scan_to_path::scan {
namespace {

constexpr double margin = 0.001;

double hill(double x, double y) { return 0.01 * std::sin(40.0 * x + 60.0 * y); }

FittedLine lineOf(int row, double x_min, double x_max, double slant = 0.0) {
  FittedLine line;
  line.row = row;
  line.forward = row % 2 == 0;
  line.curve = test::heightLine(hill, x_min, x_max, 0.004 * row, 24, Frame::Identity());
  for (Vector3& p : line.curve.control_points) p.y() += slant * p.x();
  line.begin = x_min;
  line.end = x_max;
  return line;
}

/// Rows 0 to 4; row 2 has a hole from 40 to 50 mm and row 3 begins at 30 mm.
ScanTables holedRows() {
  FittedScan scan;
  for (const auto& [row, begin, end] : std::initializer_list<std::tuple<int, double, double>>{
           {0, 0.0, 0.1}, {1, 0.0, 0.1}, {2, 0.0, 0.04}, {2, 0.05, 0.1}, {3, 0.03, 0.1}, {4, 0.0, 0.1}}) {
    scan.lines.push_back(lineOf(row, begin, end));
  }
  return makeTables(scan);
}

TEST(RowNeighbours, FindsTheLineThatPassesOrNone) {
  const ScanTables tables = holedRows();
  RowNeighbours neighbours(tables, 1, margin);
  EXPECT_EQ(neighbours.lineAt(-1, 0.02), 0U);
  EXPECT_EQ(neighbours.lineAt(0, 0.02), 1U);
  EXPECT_EQ(neighbours.lineAt(1, 0.02), 2U);
  EXPECT_EQ(neighbours.lineAt(1, 0.0409), 2U);  // within the margin behind its end
  EXPECT_FALSE(neighbours.lineAt(1, 0.0411));
  EXPECT_FALSE(neighbours.lineAt(1, 0.0489));
  EXPECT_EQ(neighbours.lineAt(1, 0.0491), 3U);
  EXPECT_EQ(neighbours.lineAt(1, 0.09), 3U);
  EXPECT_FALSE(neighbours.lineAt(1, 0.1011));
  EXPECT_EQ(neighbours.lineAt(1, 0.01), 2U);  // and back
  EXPECT_FALSE(neighbours.lineAt(2, 0.028));
  EXPECT_FALSE(neighbours.lineAt(-2, 0.02));  // beyond the first and the last row
  EXPECT_FALSE(neighbours.lineAt(4, 0.02));
}

TEST(RowNeighbours, AnswersStayAsLongAsItSays) {
  const ScanTables tables = holedRows();
  const auto answers = [&](double x) {
    RowNeighbours fresh(tables, 1, margin);
    std::vector<std::optional<std::size_t>> found;
    for (const int step : {-1, 1, 2, 3}) found.push_back(fresh.lineAt(step, x));
    return found;
  };
  RowNeighbours neighbours(tables, 1, margin);
  int renewals = 0;
  double x = 0.0;
  while (x < 0.1) {
    neighbours.resetValid();
    for (const int step : {-1, 1, 2, 3}) neighbours.lineAt(step, x);
    const double until = std::min(neighbours.validUntil(), 0.1);
    EXPECT_GT(until, x);
    for (int k = 0; k < 20; ++k) EXPECT_EQ(answers(x + (until - x) * k / 20), answers(x)) << x << " " << until;
    x = until + 1e-9;
    ++renewals;
  }
  EXPECT_EQ(renewals, 4);  // row 3 begins, row 2 ends and begins again, the end
}

TEST(RowNeighbours, PointAtPassesXOnTheCurve) {
  const ScanTables tables = holedRows();
  RowNeighbours neighbours(tables, 1, margin);
  for (double x = 0.031; x < 0.1; x += 0.0007) {
    for (const int step : {-1, 0, 1, 2, 3}) {
      if (!neighbours.lineAt(step, x)) continue;
      const Vector3 p = neighbours.pointAt(step, x);
      EXPECT_NEAR(p.x(), x, 1e-9);
      EXPECT_NEAR(p.y(), 0.004 * (1 + step), 1e-12);
      // 24 control points over 0.1 m: the interpolating cubic is off by (40 h)^4 / 384 of 10 mm, four times at its
      // ends.
      EXPECT_NEAR(p.z(), hill(x, p.y()), 0.01 * std::pow(40.0 * 0.1 / 21, 4) / 384.0 * 4.0);
    }
  }
}

TEST(RowNeighbours, NearestIsNearerThanAnyOtherPoint) {
  FittedScan scan;
  for (int row = 0; row < 3; ++row) scan.lines.push_back(lineOf(row, 0.0, 0.1, 0.5));  // y rises by half of x
  const ScanTables tables = makeTables(scan);
  RowNeighbours neighbours(tables, 1, margin);
  double gained = 0.0;
  for (double x = 0.002; x < 0.098; x += 0.001) {
    ASSERT_TRUE(neighbours.lineAt(0, x));
    const Vector3 p = neighbours.pointAt(0, x);
    for (const int step : {-1, 1}) {
      ASSERT_TRUE(neighbours.lineAt(step, x));
      const double found = (neighbours.nearestTo(step, p) - p).norm();
      double best = 1e300;
      std::size_t hint = 0;
      const LineTable& other = tables.lines[static_cast<std::size_t>(1 + step)];
      for (int k = 0; k <= 20000; ++k) best = std::min(best, (other.point(0.1 * k / 20000, hint) - p).norm());
      // Samples 5.6 um apart: the nearest one is at most (2.8 um)^2 / (2 d) = 1 nm farther than the curve, and Newton's
      // third step ends within 1 nm of the foot point.
      EXPECT_NEAR(found, best, 2e-9) << x;
      gained = std::max(gained, (neighbours.pointAt(step, x) - p).norm() - found);
    }
  }
  EXPECT_GT(gained, 1e-4);  // twin: the point at the same x is not the nearest
}

TEST(RowNeighbours, DirectionsAreTheRows) {
  const ScanTables tables = holedRows();
  const RowNeighbours neighbours(tables, 1, margin);
  EXPECT_EQ(neighbours.direction(0), -1.0);
  EXPECT_EQ(neighbours.direction(1), 1.0);
}

}  // namespace
}  // namespace scan_to_path::scan
