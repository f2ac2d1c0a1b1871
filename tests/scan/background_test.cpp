// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/background.h"

#include <gmock/gmock.h>

#include "scan_to_path/scan/fit_scan.h"
#include "support/expect_input_error.h"
#include "support/raster_scan.h"

namespace scan_to_path::scan {
namespace {

using test::freeStanding;
using test::onTable;
using test::RasterScan;

std::size_t backgroundOf(const RasterScan& scan, const test::HeightFunction& height, BackgroundOptions options = {}) {
  ScanOptions all;
  all.background = options;
  const SampleRows rows = cleanRows(scanRaster(scan, height), -scan.T_cloud_scan.linear().col(2), all);
  for (const Dropped& d : rows.dropped) {
    if (d.reason == "background") return d.count;
  }
  return 0;
}

/// Over the S part with some of the table around it.
RasterScan overscan() {
  RasterScan scan;
  scan.rows = test::evenRows(-0.006, 0.004, 44);
  scan.spacing = 0.0001;
  scan.noise = 2e-6;
  scan.T_cloud_scan = geometry::makeFrame({0.7, 0.2, 0.1}, {0.2, 0.1, -1.0});
  return scan;
}

/// Over a plate only.
RasterScan plateScan() {
  RasterScan scan = overscan();
  scan.x_min = 0.0;
  scan.x_max = 0.1;
  scan.rows = test::evenRows(0.0, 0.004, 20);
  return scan;
}

TEST(Background, TheTableGoesAndThePartStays) {
  const geometry::SPart part;
  const RasterScan scan = overscan();
  ScanOptions options;
  const SampleRows rows =
      cleanRows(scanRaster(scan, onTable(part, -0.024)), -scan.T_cloud_scan.linear().col(2), options);
  const geometry::Frame T_part_scan = scan.T_cloud_scan.inverse() * rows.T_cloud_scan;
  std::size_t on_part = 0;
  for (const RowPiece& piece : rows.pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Vector3 p = T_part_scan * Vector3(piece.x[i], piece.y[i], piece.z[i]);
      EXPECT_GT(p.z(), -0.0225);
      on_part += part.rectangle().contains(p.x(), p.y()) ? 1 : 0;
    }
  }
  EXPECT_GE(on_part, 2400u * 40u * 99u / 100u);  // 40 of the rows lie on the part
  EXPECT_EQ(rows.pieces.size(), 40u);
}

TEST(Background, WhatGoesStandsInTheWayOfTools) {
  const RasterScan scan = overscan();
  const SampleRows rows =
      cleanRows(scanRaster(scan, onTable(geometry::SPart(), -0.024)), -scan.T_cloud_scan.linear().col(2), {});
  std::size_t gone = 0;
  for (const Dropped& d : rows.dropped) gone += d.reason == "background" || d.reason == "short piece" ? d.count : 0;
  EXPECT_GT(gone, 10000U);
  EXPECT_EQ(rows.obstacles.size(), gone);
  const geometry::Frame T_part_scan = scan.T_cloud_scan.inverse() * rows.T_cloud_scan;
  for (std::size_t i = 0; i < rows.obstacles.size(); i += 100) {
    EXPECT_LT((T_part_scan * rows.obstacles[i].cast<double>()).z(), -0.0225);
  }
}

TEST(Background, ATiltedTableGoesToo) {
  const geometry::SPart part;
  const auto tilted = [&](double x, double y) -> std::optional<double> {
    if (part.rectangle().contains(x, y)) return part.jet(x, y).z;
    return -0.03 + 0.05 * x - 0.02 * y;
  };
  EXPECT_GT(backgroundOf(overscan(), tilted), 44u * 150u);
}

TEST(Background, PlateWithoutTableLosesNothing) {
  EXPECT_EQ(backgroundOf(plateScan(), [](double, double) { return 0.0; }), 0u);
}

TEST(Background, FreeStandingPartLosesNothing) {
  const geometry::SPart part;
  EXPECT_EQ(backgroundOf(overscan(), freeStanding(part)), 0u);
}

TEST(Background, StepsAndPocketsLoseNothing) {
  EXPECT_EQ(backgroundOf(plateScan(), [](double x, double) { return x < 0.05 ? 0.0 : -0.01; }), 0u);
  EXPECT_EQ(backgroundOf(plateScan(), [](double, double y) { return y < 0.041 ? 0.0 : -0.01; }), 0u);
  const auto pocket = [](double x, double y) { return x > 0.02 && x < 0.08 && y > 0.018 && y < 0.062 ? -0.012 : 0.0; };
  EXPECT_EQ(backgroundOf(plateScan(), pocket), 0u);
}

TEST(Background, TableSeenThroughAHoleGoes) {
  const auto holed = [](double x, double y) {
    const bool on_part = x > 0.01 && x < 0.09 && y > 0.009 && y < 0.07;
    return on_part && std::hypot(x - 0.05, y - 0.04) > 0.012 ? 0.0 : -0.02;
  };
  const RasterScan scan = plateScan();
  EXPECT_GT(backgroundOf(scan, holed), 0u);
  BackgroundOptions none;
  none.mode = BackgroundMode::none;
  EXPECT_EQ(backgroundOf(scan, holed, none), 0u);
}

TEST(Background, GivenHeightIsAlongTheBeamInTheCloudsFrame) {
  RasterScan scan = plateScan();
  scan.T_cloud_scan = geometry::makeFrame({0.0, 0.0, 0.5}, {0.0, 0.0, 0.3});
  BackgroundOptions options;
  options.mode = BackgroundMode::height;
  options.height = 0.49;
  const auto step = [](double x, double) { return x < 0.05 ? 0.0 : -0.01; };
  EXPECT_NEAR(static_cast<double>(backgroundOf(scan, step, options)), 20.0 * 500.0, 45.0);
  options.height = 0.6;
  test::expectInputError([&] { backgroundOf(scan, step, options); }, "samples above the background is 0");
}

/// A spherical cap of 50 mm radius, 10 mm high and 60 mm wide, `raised` over a table at 0.
test::HeightFunction capOnTable(double raised) {
  return [raised](double x, double y) -> std::optional<double> {
    const double square = 0.05 * 0.05 - x * x - y * y;
    return std::hypot(x, y) < 0.03 ? raised + std::sqrt(square) - 0.04 : 0.0;
  };
}

RasterScan capScan() {
  RasterScan scan = overscan();
  scan.x_min = -0.05;
  scan.x_max = 0.05;
  scan.rows = test::evenRows(-0.042, 0.004, 22);
  scan.T_cloud_scan = geometry::makeFrame({0.1, 0.2, 0.5}, {0.0, 0.0, 0.3});
  return scan;
}

std::optional<FlushPlane> flushPlaneOf(const RasterScan& scan, const test::HeightFunction& height,
                                       const BackgroundOptions& options = {}) {
  ScanOptions all;
  all.background = options;
  return findFlushPlane(cleanRows(scanRaster(scan, height), -scan.T_cloud_scan.linear().col(2), all), options);
}

// Of 22 lines of 100 mm the cap's chords at y = +-2, +-6, ... +-26 mm take 694.0 mm: 68.45 % lies beside it, and the
// lowest 0.1 mm at the chords' ends, slopes of 0.75 down to 0.37, adds 4.8 mm: 0.22 %.
TEST(FlushPlane, ATableThatAPartLiesFlushOnIsFound) {
  EXPECT_EQ(backgroundOf(capScan(), capOnTable(0.0)), 0u);
  const auto flush = flushPlaneOf(capScan(), capOnTable(0.0));
  ASSERT_TRUE(flush);
  EXPECT_NEAR(flush->share, 0.6867, 0.002);
  EXPECT_NEAR(flush->height, 0.5, 1e-5);  // noise of 2 um over 15,000 samples, and the lowest of the cap
}

// What the user is told to do does it.
TEST(FlushPlane, ItsHeightTakesItAway) {
  BackgroundOptions options;
  options.mode = BackgroundMode::height;
  options.height = flushPlaneOf(capScan(), capOnTable(0.0))->height;
  EXPECT_GT(backgroundOf(capScan(), capOnTable(0.0), options), 22u * 1000u * 68u / 100u);
  EXPECT_FALSE(flushPlaneOf(capScan(), capOnTable(0.0), options)) << "the user has said what the table is";
  options.mode = BackgroundMode::none;
  EXPECT_FALSE(flushPlaneOf(capScan(), capOnTable(0.0), options));
}

TEST(FlushPlane, WhereThereIsAStepTheTableIsGone) {
  EXPECT_GT(backgroundOf(capScan(), capOnTable(0.003)), 0u);
  EXPECT_FALSE(flushPlaneOf(capScan(), capOnTable(0.003)));
  const geometry::SPart part;
  EXPECT_FALSE(flushPlaneOf(overscan(), onTable(part, -0.024)));
  EXPECT_FALSE(flushPlaneOf(overscan(), freeStanding(part)));
}

TEST(FlushPlane, CurvedBordersAreNoPlane) {
  EXPECT_FALSE(flushPlaneOf(capScan(), [](double x, double y) { return x * x - y * y; }));
  EXPECT_FALSE(flushPlaneOf(capScan(), [](double x, double y) { return x * x + y * y; })) << "the part is beyond it";
  const auto roof = flushPlaneOf(capScan(), [](double x, double) { return -2.0 * x * x; });
  EXPECT_LT(roof ? roof->share : 0.0, 0.02) << "0.1 mm of slopes of 0.2 at both ends of lines of 100 mm";
}

}  // namespace
}  // namespace scan_to_path::scan
