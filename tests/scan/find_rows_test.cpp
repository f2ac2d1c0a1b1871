// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/find_rows.h"

#include <gmock/gmock.h>

#include "support/expect_input_error.h"
#include "support/raster_scan.h"

namespace scan_to_path::scan {
namespace {

using geometry::makeFrame;
using test::evenRows;
using test::expectInputError;
using test::RasterScan;
using test::scanRaster;

const test::HeightFunction flat = [](double, double) { return std::optional<double>(0.0); };

RasterScan smallScan() {
  RasterScan scan;
  scan.x_min = 0.0;
  scan.x_max = 0.06;
  scan.rows = evenRows(0.0, 0.004, 6);
  scan.spacing = 0.0001;
  return scan;
}

SampleRows rowsOf(const RasterScan& scan, const test::HeightFunction& height = flat) {
  return findRows(scanRaster(scan, height), -scan.T_cloud_scan.linear().col(2), {});
}

std::size_t lost(const SampleRows& rows) {
  std::size_t count = 0;
  for (const Dropped& d : rows.dropped) count += d.count;
  return count;
}

ScanPoint pointAt(double x, double y, double z = 0.0) {
  ScanPoint point;
  point.x = static_cast<float>(x);
  point.y = static_cast<float>(y);
  point.z = static_cast<float>(z);
  point.line = no_line;
  point.time = 0.0;
  return point;
}

TEST(FindRows, ZigZagWithTurns) {
  const SampleRows rows = rowsOf(smallScan());
  ASSERT_EQ(rows.pieces.size(), 6u);
  EXPECT_NEAR(rows.pitch, 0.004, 1e-7);
  EXPECT_NEAR(rows.spacing, 0.0001, 1e-7);
  EXPECT_EQ(sampleCount(rows) + lost(rows), rows.samples_in);
  for (std::size_t i = 0; i < 6; ++i) {
    const RowPiece& piece = rows.pieces[i];
    EXPECT_EQ(piece.row, static_cast<int>(i));
    EXPECT_EQ(piece.forward, i % 2 == 0);
    EXPECT_TRUE(std::is_sorted(piece.x.begin(), piece.x.end()));
    EXPECT_NEAR(piece.x.back() - piece.x.front(), 0.06, 0.00011);  // ends exact to one spacing
    for (const double y : piece.y) EXPECT_NEAR(y, piece.y.front(), 0.00011);
  }
}

TEST(FindRows, OneWayWithoutTurns) {
  RasterScan scan = smallScan();
  scan.zigzag = false;
  const SampleRows rows = rowsOf(scan);
  ASSERT_EQ(rows.pieces.size(), 6u);
  EXPECT_EQ(lost(rows), 0u);
  for (const RowPiece& piece : rows.pieces) EXPECT_TRUE(piece.forward);
}

TEST(FindRows, ScanFrameFollowsBeamAndFirstRow) {
  RasterScan scan = smallScan();
  scan.T_cloud_scan = makeFrame({0.5, -0.2, 0.3}, {0.5, -0.8, 2.5});
  const SampleRows rows = rowsOf(scan);
  const Eigen::Matrix3d R = scan.T_cloud_scan.linear().transpose() * rows.T_cloud_scan.linear();
  EXPECT_LT(geometry::rotationAngle(Eigen::Matrix3d::Identity(), R), 1e-5);
  const RowPiece& piece = rows.pieces[0];
  const Vector3 p = scan.T_cloud_scan.inverse() * (rows.T_cloud_scan * Vector3(piece.x[0], piece.y[0], piece.z[0]));
  EXPECT_LT(p.norm(), 1e-6);  // the raster's first sample, in floats
}

TEST(FindRows, UnevenPitchAndOrderAcross) {
  RasterScan scan = smallScan();
  scan.rows = {0.020, 0.015, 0.012, 0.007, 0.004};  // from far to near
  const SampleRows rows = rowsOf(scan);
  ASSERT_EQ(rows.pieces.size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_GT(rows.pieces[i].y[0], rows.pieces[i - 1].y[0]);
}

TEST(FindRows, HolesWithoutReturnLeaveOneRow) {
  const auto holed = [](double x, double y) -> std::optional<double> {
    if (std::hypot(x - 0.03, y - 0.01) < 0.006) return std::nullopt;
    return 0.0;
  };
  const SampleRows rows = rowsOf(smallScan(), holed);
  ASSERT_EQ(rows.pieces.size(), 6u);
  EXPECT_NEAR(rows.pieces[2].x.back() - rows.pieces[2].x.front(), 0.06, 0.00011);
}

TEST(FindRows, ShakingWhereTheRobotStopsIsPutInOrder) {
  Random random(1);
  ScanCloud cloud;
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 200; ++k) cloud.push_back(pointAt(0.0 + 2e-6 * random.gaussian(), 0.004 * row));
    for (int k = 0; k < 500; ++k) cloud.push_back(pointAt(0.0001 * k, 0.004 * row));
  }
  const SampleRows rows = findRows(cloud, -Vector3::UnitZ(), {});
  ASSERT_EQ(rows.pieces.size(), 3u);
  for (const RowPiece& piece : rows.pieces) EXPECT_TRUE(std::is_sorted(piece.x.begin(), piece.x.end()));
}

TEST(FindRows, GivenLinesAreTakenAsTheyAre) {
  ScanCloud cloud;
  for (std::uint32_t line = 0; line < 3; ++line) {
    for (int k = 0; k < 100; ++k) {
      cloud.push_back(pointAt(0.001 * k, 0.01 * line));
      cloud.back().line = 7 - line;
    }
    cloud.push_back(pointAt(0.0, 0.5));  // of no line
  }
  const SampleRows rows = findRows(cloud, -Vector3::UnitZ(), {});
  ASSERT_EQ(rows.pieces.size(), 3u);
  EXPECT_EQ(rows.pieces[0].size(), 100u);
  EXPECT_THAT(rows.dropped, ::testing::ElementsAre(::testing::Field(&Dropped::reason, "no line")));
}

TEST(FindRows, RefusesWhatIsNoRaster) {
  RasterScan one = smallScan();
  one.rows = {0.0};
  expectInputError([&] { rowsOf(one); }, "number of scan rows is 1, must be at least 2");

  ScanCloud pairs;
  for (int row = 0; row < 50; ++row) {
    pairs.push_back(pointAt(0.0, 0.01 * row));
    pairs.push_back(pointAt(0.05, 0.01 * row));
    pairs.back().line = pairs[pairs.size() - 2].line = static_cast<std::uint32_t>(row);
  }
  expectInputError([&] { findRows(pairs, -Vector3::UnitZ(), {}); }, "samples on the longest scan row is 2");

  Random random(1);
  ScanCloud shuffled;
  for (int i = 0; i < 5000; ++i) shuffled.push_back(pointAt(random.uniform(), random.uniform()));
  expectInputError([&] { findRows(shuffled, -Vector3::UnitZ(), {}); }, "");

  expectInputError([] { findRows(ScanCloud(), -Vector3::UnitZ(), {}); }, "number of finite points on lines is 0");
  expectInputError([&] { findRows(shuffled, Vector3::Zero(), {}); }, "mean beam direction");
}

TEST(FindRows, RefusesCrossingLines) {
  ScanCloud cloud;
  for (int row = 0; row < 4; ++row) {
    const double slope = row == 2 ? -0.3 : 0.0;  // across the row before
    for (int k = 0; k < 600; ++k) cloud.push_back(pointAt(0.0001 * k, 0.004 * row + slope * (0.0001 * k - 0.025)));
  }
  expectInputError([&] { findRows(cloud, -Vector3::UnitZ(), {}); }, " cross");
  ScanCloud grid;
  for (int row = 0; row < 6; ++row) {
    for (int k = 0; k < 600; ++k) grid.push_back(pointAt(0.0001 * k, 0.01 * row));
  }
  for (int row = 0; row < 6; ++row) {
    for (int k = 0; k < 600; ++k) grid.push_back(pointAt(0.01 * row, 0.0001 * k));
  }
  expectInputError([&] { findRows(grid, -Vector3::UnitZ(), {}); }, "travelling along one direction");
}

// A few rows across the others are no turns: what was measured there is not used, and that is said.
TEST(FindRows, RowsAcrossTheOthersAreCountedAsSuch) {
  ScanCloud cloud;
  for (int row = 0; row < 12; ++row) {
    for (int k = 0; k < 600; ++k) cloud.push_back(pointAt(0.0001 * (row % 2 == 0 ? k : 599 - k), 0.004 * row));
    for (int k = 1; k < 40; ++k) cloud.push_back(pointAt(row % 2 == 0 ? 0.06 : 0.0, 0.004 * row + 0.0001 * k));
  }
  const auto across = [](const SampleRows& rows) {
    const auto found = std::find_if(rows.dropped.begin(), rows.dropped.end(),
                                    [](const Dropped& d) { return d.reason == "across the rows"; });
    return found == rows.dropped.end() ? 0U : found->count;
  };
  EXPECT_EQ(across(findRows(cloud, -Vector3::UnitZ(), {})), 0U);
  for (int k = 0; k < 480; ++k) cloud.push_back(pointAt(0.0, 0.048 - 0.0001 * k));
  const SampleRows rows = findRows(cloud, -Vector3::UnitZ(), {});
  EXPECT_NEAR(static_cast<double>(across(rows)), 480.0 + 39.0, 40.0);  // and the last row's turn, which it goes on from
  EXPECT_EQ(sampleCount(rows) + lost(rows), rows.samples_in);
}

TEST(FindRows, PointsThatAreNotFiniteAreCounted) {
  ScanCloud cloud = scanRaster(smallScan(), flat);
  cloud[17].x = std::nanf("");
  cloud[40].z = INFINITY;
  const SampleRows rows = findRows(cloud, -Vector3::UnitZ(), {});
  EXPECT_EQ(rows.dropped[0].reason, "not finite");
  EXPECT_EQ(rows.dropped[0].count, 2u);
}

}  // namespace
}  // namespace scan_to_path::scan
