// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/row_scallop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/toolpath/scallop.h"
#include "support/fitted_scans.h"

namespace scan_to_path::process {
namespace {

constexpr double radius = 0.02;
constexpr double h = 1e-4;
const geometry::Rectangle trough = {0.0, 0.05, -0.02, 0.02};

/// A row along x at angle `across` round a cylinder of signed radius rho with its axis along x, top at z = 0.
Row cylinderRow(double rho, double across, double x_begin = 0.0, double x_end = 0.05) {
  Row row;
  for (int i = 0; i <= 20; ++i) {
    RowPoint p;
    p.t = x_begin + (x_end - x_begin) * i / 20.0;
    p.normal = {0.0, std::sin(across), std::cos(across)};
    p.point = Vector3(p.t, 0.0, -rho) + rho * p.normal;
    row.points.push_back(p);
  }
  return row;
}

test::Height cylinder(double rho) {
  return [rho](double, double y) { return -rho + std::copysign(std::sqrt(rho * rho - y * y), rho); };
}

TEST(RowScallop, IsThePlanesHeight) {
  const auto surface = test::heightSurface([](double, double) { return 0.0; }, trough, 6, 6);
  const double L = toolpath::rowDistance(h, radius, 0.0);
  Row a = cylinderRow(1e9, 0.0);
  Row b = a;
  for (RowPoint& p : b.points) p.point.y() = L;
  EXPECT_NEAR(*widestScallop(a, b, toolpath::ScanSurface(surface), radius), h, 1e-12);
}

TEST(RowScallop, IsTheExactRulesHeightOnConvexAndHollowCylinders) {
  for (const double rho : {0.05, 0.1, 0.5, -0.05, -0.1, -0.5}) {
    const auto surface = test::heightSurface(cylinder(rho), trough, 6, 200);
    const double L = toolpath::rowDistance(h, radius, 1.0 / rho);
    const double start = -0.005 / rho;
    const auto height = widestScallop(cylinderRow(rho, start), cylinderRow(rho, start + L / rho),
                                      toolpath::ScanSurface(surface), radius);
    ASSERT_TRUE(height);
    // The surface interpolates to a nanometre; the height is measured to second order in h / rho.
    EXPECT_NEAR(*height, h, 3e-9) << rho;
    // Twin: rows five percent farther apart leave ten percent more.
    const auto wider = widestScallop(cylinderRow(rho, start), cylinderRow(rho, start + 1.05 * L / rho),
                                     toolpath::ScanSurface(surface), radius);
    EXPECT_NEAR(*wider, 1.1 * h, 0.01 * h) << rho;
  }
}

TEST(RowScallop, DoesNotDependOnWhichRowComesFirst) {
  const auto surface = test::heightSurface(cylinder(0.1), trough, 6, 200);
  const toolpath::ScanSurface heights(surface);
  const Row a = cylinderRow(0.1, 0.0), b = cylinderRow(0.1, 0.04);
  EXPECT_NEAR(*widestScallop(a, b, heights, radius), *widestScallop(b, a, heights, radius), 1e-12);
}

TEST(RowScallop, IsNothingWhereRowsDoNotRunSideBySide) {
  const auto surface = test::heightSurface(cylinder(0.1), trough, 6, 50);
  const toolpath::ScanSurface heights(surface);
  EXPECT_FALSE(widestScallop(cylinderRow(0.1, 0.0, 0.0, 0.02), cylinderRow(0.1, 0.04, 0.03, 0.05), heights, radius));
  EXPECT_FALSE(widestScallop(std::vector<Row>{}, {cylinderRow(0.1, 0.0)}, heights, radius));
  EXPECT_TRUE(widestScallop({cylinderRow(0.1, 0.0)}, {cylinderRow(0.1, 0.04, 0.0, 0.01), cylinderRow(0.1, 0.04)},
                            heights, radius));
}

TEST(RowScallop, IsInfiniteWhereTheBallsDoNotMeet) {
  const auto surface = test::heightSurface([](double, double) { return 0.0; }, trough, 6, 6);
  Row a = cylinderRow(1e9, 0.0);
  Row b = a;
  for (RowPoint& p : b.points) p.point.y() = 0.041;
  EXPECT_TRUE(std::isinf(*widestScallop(a, b, toolpath::ScanSurface(surface), radius)));
}

}  // namespace
}  // namespace scan_to_path::process
