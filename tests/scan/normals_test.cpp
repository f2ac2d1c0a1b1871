// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/normals.h"

#include <gmock/gmock.h>

#include "scan_to_path/scan/fit_scan.h"
#include "support/expect_input_error.h"
#include "support/raster_scan.h"
#include "support/scan_accuracy.h"

namespace scan_to_path::scan {
namespace {

using geometry::HeightJet;
using test::freeStanding;
using test::measureAccuracy;
using test::RasterScan;

/// A smooth bowl without noise: 0.1 m by 0.06 m.
class Bowl : public geometry::HeightField {
public:
  Bowl() : HeightField({0.0, 0.1, 0.0, 0.06}, {-0.1, 0.1, 100.0}) {}
  HeightJet jet(double x, double y) const override {
    const double a = 3.0;  // [1/m]
    const double b = 5.0;
    return {a * x * x + b * y * y + x * y, 2 * a * x + y, 2 * b * y + x, 2 * a, 1.0, 2 * b};
  }
};

RasterScan bowlScan() {
  RasterScan scan;
  scan.x_min = 0.0;
  scan.x_max = 0.1;
  scan.rows = {0.0, 0.003, 0.008, 0.011, 0.016, 0.019, 0.024};
  scan.spacing = 0.0001;
  return scan;
}

FittedScan fit(const RasterScan& scan, const test::HeightFunction& height) {
  return fitScan(scanRaster(scan, height), -scan.T_cloud_scan.linear().col(2), {}, {});
}

TEST(Normals, WeightedIsExactOnQuadricsAtAnyPitchOnTheBorderToo) {
  const Bowl bowl;
  const FittedScan scan = fit(bowlScan(), freeStanding(bowl));
  const auto weighted = measureAccuracy(orientLines(scan, {}, NormalMode::weighted).lines, scan, bowl);
  // Second order is exact here; what stays are coordinates in floats: 4e-9 m over 3 mm, 8e-5 degrees, factor 3.
  EXPECT_LT(weighted.all.largest, 3e-4);
  // The seed's rule errs by curvature * |L1 - L2| / 2 = 10 * 1 mm = 0.57 degrees, on the border by more.
  const auto seed = measureAccuracy(orientLines(scan, {}, NormalMode::seed).lines, scan, bowl);
  EXPECT_GT(seed.inside.mean(), 0.1);
  EXPECT_GT(seed.border.largest, 0.57);
  EXPECT_LT(seed.all.largest, 3.0);
  const auto surface = measureAccuracy(orientLines(scan, {}, NormalMode::surface).lines, scan, bowl);
  EXPECT_LT(surface.all.largest, 1e-3);
}

TEST(Normals, PlaneIsExactInAllModesAndFrames) {
  RasterScan scan = bowlScan();
  scan.T_cloud_scan = geometry::makeFrame({0.1, 0.2, 0.3}, {2.5, 0.3, -1.0});
  const FittedScan fitted = fit(scan, [](double x, double y) { return 0.3 * x - 0.2 * y; });
  const Vector3 truth = scan.T_cloud_scan.linear() * Vector3(-0.3, 0.2, 1.0).normalized();
  for (const NormalMode mode : {NormalMode::weighted, NormalMode::seed, NormalMode::surface}) {
    const OrientedScan oriented = orientLines(fitted, {}, mode);
    EXPECT_TRUE(oriented.dropped.empty());
    for (const OrientedLine& line : oriented.lines) {
      for (const OrientedPoint& p : line.points) {
        EXPECT_LT(geometry::angleBetween(p.normal, truth), 2e-5) << enumName(mode);  // floats: 3e-8 m over 3 mm
        EXPECT_NEAR(p.normal.norm(), 1.0, 1e-12);
        EXPECT_NEAR(p.tangent.norm(), 1.0, 1e-12);
        EXPECT_NEAR(p.tangent.dot(p.normal), 0.0, 2e-5);
        EXPECT_GT(p.tangent.dot(fitted.T_cloud_scan.linear().col(0)), 0.0);
      }
    }
  }
}

TEST(Normals, ClockOffsetCancelsOnlyWithTheDirections) {
  const Bowl bowl;
  RasterScan scan = bowlScan();
  scan.clock_offset = 0.002;  // rows shift by +-0.1 mm
  FittedScan fitted = fit(scan, freeStanding(bowl));
  const auto largest = [&](const FittedScan& s) {
    return measureAccuracy(orientLines(s, {}, NormalMode::weighted).lines, s, bowl).inside.largest;
  };
  // A point is 0.1 mm from where it was measured: the truth turns by up to 10 /m * 0.1 mm = 0.057 degrees.
  EXPECT_LT(largest(fitted), 0.08);
  for (FittedLine& line : fitted.lines) line.forward = true;  // twin: without the directions
  EXPECT_GT(largest(fitted), 0.3);
}

TEST(Normals, PointsWithoutNeighboursAreLeftOut) {
  // Rows 0-2 reach from 0 to 0.1 m, row 3 ends at 0.05 m and rows 4 and 5 begin at 0.07 m.
  const auto ragged = [](double x, double y) -> std::optional<double> {
    if (y > 0.01 && y < 0.014 && x > 0.05) return std::nullopt;
    if (y >= 0.014 && x < 0.07) return std::nullopt;
    return 0.1 * x + 0.2 * y;
  };
  RasterScan scan = bowlScan();
  scan.zigzag = false;
  scan.rows = {0.0, 0.004, 0.008, 0.012, 0.016, 0.020};
  const FittedScan fitted = fit(scan, ragged);
  EXPECT_TRUE(orientLines(fitted, {}, NormalMode::weighted).dropped.empty());
  scan.rows.pop_back();  // now row 4 has no neighbour left
  const FittedScan lonely = fit(scan, ragged);
  for (const NormalMode mode : {NormalMode::weighted, NormalMode::seed}) {
    const OrientedScan oriented = orientLines(lonely, {}, mode);
    EXPECT_EQ(oriented.lines.size(), 4u);
    ASSERT_EQ(oriented.dropped.size(), 1u);
    EXPECT_EQ(oriented.dropped[0].reason, "no neighbouring row");
    EXPECT_NEAR(static_cast<double>(oriented.dropped[0].count), 31.0, 1.0);  // 0.03 m at 1 mm
    const Vector3 truth = Vector3(-0.1, -0.2, 1.0).normalized();
    for (const OrientedLine& line : oriented.lines) {
      for (const OrientedPoint& p : line.points) EXPECT_LT(geometry::angleBetween(p.normal, truth), 1e-4);
    }
  }
}

TEST(Normals, RowsBesideAStepOrRoofEdgeLookToTheirOwnSide) {
  RasterScan scan = bowlScan();
  scan.rows = test::evenRows(0.0, 0.004, 12);
  const FittedScan step = fit(scan, [](double x, double y) { return 0.1 * x + (y > 0.022 ? 0.01 : 0.0); });
  const Vector3 level = Vector3(-0.1, 0.0, 1.0).normalized();
  for (const OrientedLine& line : orientLines(step, {}, NormalMode::weighted).lines) {
    for (const OrientedPoint& p : line.points) EXPECT_LT(geometry::angleBetween(p.normal, level), 1e-4);
  }
  const FittedScan roof = fit(scan, [](double, double y) { return 0.02 - std::abs(y - 0.022); });
  for (const OrientedLine& line : orientLines(roof, {}, NormalMode::weighted).lines) {
    for (const OrientedPoint& p : line.points) {
      const Vector3 side(0.0, p.point.y() < 0.022 ? -1.0 : 1.0, 1.0);
      EXPECT_LT(geometry::angleBetween(p.normal, side), 1e-4) << p.point.y();
    }
  }
}

TEST(Normals, RefusesWhatItCannotDo) {
  const Bowl bowl;
  FittedScan scan = fit(bowlScan(), freeStanding(bowl));
  const NormalEstimator estimator(scan, NormalMode::weighted);
  test::expectInputError([&] { estimator.orient(7, {0.0}); }, "line is 7, must be in [0, 7)");
  EXPECT_TRUE(estimator.orient(0, {}).points.empty());
  scan.surface = {};
  test::expectInputError([&] { NormalEstimator(scan, NormalMode::surface); }, "fitted surface is missing");
}

}  // namespace
}  // namespace scan_to_path::scan
