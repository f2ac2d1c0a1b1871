// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/line_table.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"
#include "support/fitted_scans.h"

namespace scan_to_path::scan {
namespace {

double tiltedWave(double x, double y) { return 0.01 * std::sin(40.0 * x) + 0.2 * y; }

/// A line over 0.1 m in a turned frame, its knots of uneven width and one of them double.
FittedLine unevenLine(const Frame& T) {
  FittedLine line;
  line.curve = test::heightLine(tiltedWave, 0.0, 0.1, 0.02, 12, T);
  for (const double u : {0.013, 0.0131, 0.05, 0.05, 0.07}) line.curve = nurbs::insertKnot(line.curve, u);
  line.begin = 0.004;
  line.end = 0.093;
  return line;
}

const Frame T_cloud_scan = geometry::makeFrame({0.3, -0.2, 0.5}, {0.4, -0.3, 2.0});

TEST(LineTable, AgreesWithTheCurveEverywhere) {
  const FittedLine line = unevenLine(T_cloud_scan);
  const LineTable table(line, T_cloud_scan.inverse());
  EXPECT_EQ(table.begin(), 0.004);
  EXPECT_EQ(table.end(), 0.093);
  EXPECT_NEAR(table.xBegin(), 0.004, 1e-15);
  EXPECT_NEAR(table.xEnd(), 0.093, 1e-15);
  const Eigen::Matrix3d R = T_cloud_scan.linear().transpose();
  Random random(1);
  std::size_t hint = 0;
  for (int k = 0; k < 2000; ++k) {  // in any order: the hint may be far off
    const double u = random.uniform(0.0, 0.1);
    const nurbs::CurvePoint truth = nurbs::evaluate(line.curve, u);
    const LineTable::Jet jet = table.jet(u, hint);
    // Roundings of coordinates of 0.6 m; a derivative divides them by half a knot span of 0.1 mm, a second one twice.
    EXPECT_LT((T_cloud_scan * jet.point - truth.point).norm(), 1e-15);
    EXPECT_LT((jet.first - R * truth.first).norm(), 1e-15 / 5e-5);
    EXPECT_LT((jet.second - R * truth.second).norm(), 1e-15 / 5e-5 / 5e-5);
    EXPECT_EQ(table.point(u, hint), jet.point);
  }
}

TEST(LineTable, BreaksAreTheDistinctKnots) {
  const LineTable table(unevenLine(Frame::Identity()), Frame::Identity());
  EXPECT_EQ(table.breaks().front(), 0.0);
  EXPECT_EQ(table.breaks().back(), 0.1);
  EXPECT_TRUE(std::adjacent_find(table.breaks().begin(), table.breaks().end(), std::greater_equal<>()) ==
              table.breaks().end());
  EXPECT_EQ(table.breaks().size(), 10U + 4U);  // 12 control points have 9 spans; four more places
}

TEST(LineTable, PassesXFromAnyFirstGuess) {
  FittedLine line = unevenLine(Frame::Identity());
  for (Vector3& p : line.curve.control_points) p.x() += 0.3 * p.x() * p.x();  // x is no longer the parameter
  const LineTable table(line, Frame::Identity());
  Random random(2);
  for (int k = 0; k < 1000; ++k) {
    const double x = random.uniform(table.xBegin(), table.xEnd());
    double u = random.uniform(0.0, 0.1);
    std::size_t hint = 0;
    const Vector3 p = table.pointAtX(x, u, hint);
    EXPECT_NEAR(p.x(), x, 1e-9);
    EXPECT_EQ(p, table.point(u, hint));
  }
}

TEST(LineTable, RefusesOtherCurves) {
  FittedLine line = unevenLine(Frame::Identity());
  line.curve.degree = 2;
  test::expectInputError([&] { LineTable(line, Frame::Identity()); },
                         "rational or of degree 2, must be a cubic B-spline");
  line.curve.degree = 3;
  line.curve.weights.assign(line.curve.control_points.size(), 1.0);
  test::expectInputError([&] { LineTable(line, Frame::Identity()); }, "must be a cubic B-spline");
}

TEST(ScanTables, KnowTheLinesOfEachRowAlsoOfEmptyOnes) {
  FittedScan scan;
  scan.T_cloud_scan = T_cloud_scan;
  const auto add = [&](int row, bool forward) {
    scan.lines.push_back(unevenLine(T_cloud_scan));
    scan.lines.back().row = row;
    scan.lines.back().forward = forward;
  };
  add(1, false);
  add(1, false);
  add(4, true);
  const ScanTables tables = makeTables(scan);
  EXPECT_EQ(tables.rowCount(), 5);
  EXPECT_THAT(tables.row_first, testing::ElementsAre(0, 0, 2, 2, 2, 3));
  EXPECT_EQ(tables.row_forward[1], 0);
  EXPECT_EQ(tables.row_forward[4], 1);
  EXPECT_EQ(makeTables({}).rowCount(), 0);
}

}  // namespace
}  // namespace scan_to_path::scan
