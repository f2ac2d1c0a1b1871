// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/fit_scan.h"

#include <gmock/gmock.h>

#include <atomic>

#include "scan_to_path/scan/outline.h"
#include "support/expect_input_error.h"
#include "support/raster_scan.h"
#include "support/scan_accuracy.h"

namespace scan_to_path::scan {
namespace {

using geometry::makeFrame;
using geometry::SPart;
using test::evenRows;
using test::expectInputError;
using test::measureAccuracy;
using test::onTable;
using test::RasterScan;
using test::ScanAccuracy;

constexpr double um = 1e-6;
constexpr double table = -0.024;

/// Error set `white` on the S part with its table, in a robot base frame.
RasterScan whiteScan(std::uint64_t seed) {
  RasterScan scan;
  scan.rows = evenRows(0.0, 0.004, 41);
  scan.noise = 10 * um;
  scan.seed = seed;
  scan.T_cloud_scan = makeFrame({0.8, 0.1, 0.3}, {0.1, -0.05, 0.7});
  return scan;
}

FittedScan fit(const RasterScan& scan, FitOptions options = {}, int threads = 1) {
  const SPart part;
  const Vector3 beam = -scan.T_cloud_scan.linear().col(2);
  return fitScan(scanRaster(scan, onTable(part, table)), beam, {}, options, threads);
}

std::size_t droppedFor(const std::vector<Dropped>& dropped, const std::string& reason) {
  for (const Dropped& d : dropped) {
    if (d.reason == reason) return d.count;
  }
  return 0;
}

ScanAccuracy accuracyOf(const FittedScan& scan, NormalMode mode, const RasterScan& raster) {
  ResampleOptions resample;
  resample.spacing = 0.0002;
  return measureAccuracy(orientLines(scan, resample, mode).lines, scan, SPart(), raster.T_cloud_scan);
}

std::vector<double> unevenRows() {  // 3 and 5 mm in turn
  std::vector<double> rows{0.0};
  while (rows.back() < 0.159) rows.push_back(rows.back() + (rows.size() % 2 == 1 ? 0.003 : 0.005));
  return rows;
}

/// Root mean square error of all lines at a fixed number of control points: what the automatic choice competes with.
double rmsWithCount(const SampleRows& rows, const RasterScan& raster, int count) {
  const SPart part;
  test::Statistic distance;
  for (const RowPiece& piece : rows.pieces) {
    const nurbs::LineMoments moments({piece.x.data(), piece.x.data(), piece.y.data(), piece.z.data(), piece.size()});
    const nurbs::CurveFit curve = moments.fit(count);
    if (!curve.fitted) return 1e300;
    for (double u = moments.first(); u < moments.last(); u += 0.0004) {
      const Vector3 p = raster.T_cloud_scan.inverse() * (rows.T_cloud_scan * nurbs::pointAt(curve.curve, u));
      const geometry::HeightJet jet = part.jet(p.x(), p.y());
      distance.add((p.z() - jet.z) / std::sqrt(1.0 + jet.zx * jet.zx + jet.zy * jet.zy));
    }
  }
  return distance.rms();
}

TEST(FitScan, WhiteRowsAreAsGoodAsTheBestNumberOfControlPoints) {
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RasterScan raster = whiteScan(seed);
    const SPart part;
    const SampleRows rows =
        cleanRows(scanRaster(raster, onTable(part, table)), -raster.T_cloud_scan.linear().col(2), {});
    FitOptions options;
    options.with_surface = false;
    const FittedScan scan = fitRows(rows, options);
    EXPECT_EQ(scan.lines.size(), 41u);
    const double rms = accuracyOf(scan, NormalMode::weighted, raster).distance.rms();
    double best = 1e300;
    for (int count = 8; count <= 40; count += 2) best = std::min(best, rmsWithCount(rows, raster, count));
    EXPECT_LE(rms, 1.1 * best + 0.05 * um) << "seed " << seed;          // acceptance bar
    EXPECT_LE(rms, 1.5 * um) << "seed " << seed;                        // acceptance bar
    EXPECT_GT(rmsWithCount(rows, raster, 10), 1.1 * best + 0.05 * um);  // twins: too few, too many control points
    EXPECT_GT(rmsWithCount(rows, raster, 120), 1.1 * best + 0.05 * um);
    worst = std::max(worst, rms);
  }
  RecordProperty("worst_rms_nm", static_cast<int>(worst * 1e9));
}

struct NormalCase {
  const char* name;
  bool uneven;
  double clock_offset;
};

class WhiteNormals : public ::testing::TestWithParam<NormalCase> {};

TEST_P(WhiteNormals, MeetTheBars) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RasterScan raster = whiteScan(seed);
    if (GetParam().uneven) raster.rows = unevenRows();
    raster.clock_offset = GetParam().clock_offset;
    const FittedScan scan = fit(raster);
    const ScanAccuracy weighted = accuracyOf(scan, NormalMode::weighted, raster);
    EXPECT_LE(weighted.all.mean(), 0.02) << "seed " << seed;  // acceptance bars [deg]
    EXPECT_LE(weighted.inside.largest, 0.2) << "seed " << seed;
    EXPECT_LE(weighted.border.largest, 0.2) << "seed " << seed;
    EXPECT_LE(accuracyOf(scan, NormalMode::seed, raster).all.mean(), 0.1);  // only to be beside them
    if (GetParam().clock_offset == 0.0) {
      EXPECT_LE(accuracyOf(scan, NormalMode::surface, raster).all.mean(), 0.01) << "seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pitch, WhiteNormals,
                         ::testing::Values(NormalCase{"even", false, 0.0}, NormalCase{"uneven", true, 0.0},
                                           NormalCase{"even_late", false, 0.0002},
                                           NormalCase{"uneven_late", true, 0.0002}),
                         [](const auto& info) { return info.param.name; });

/// Worst of five seeds with `times` the sensor's noise, the truth tilted about x [rad].
struct WorstNormals {
  double mean = 0.0, inside = 0.0, border = 0.0, surface = 0.0;  // [deg]

  explicit WorstNormals(double times, double tilt = 0.0) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      RasterScan raster = whiteScan(seed);
      raster.noise *= times;
      const FittedScan scan = fit(raster);
      raster.T_cloud_scan = raster.T_cloud_scan * makeFrame({0, 0, 0}, {tilt, 0, 0});
      const ScanAccuracy weighted = accuracyOf(scan, NormalMode::weighted, raster);
      mean = std::max(mean, weighted.all.mean());
      inside = std::max(inside, weighted.inside.largest);
      border = std::max(border, weighted.border.largest);
      surface = std::max(surface, accuracyOf(scan, NormalMode::surface, raster).all.mean());
    }
  }
};

TEST(FitScan, EveryNormalBarNoticesNoise) {
  // Means grow with the noise but for what the part's shape leaves, 0.003 of 0.011 degrees.
  EXPECT_GT(WorstNormals(2.0).border, 0.2);
  const WorstNormals threefold(3.0);
  EXPECT_GT(threefold.mean, 0.02);
  EXPECT_GT(threefold.surface, 0.01);
  EXPECT_GT(WorstNormals(6.0).inside, 0.2);
}

TEST(FitScan, NormalMeansNoticeATiltOfAFewHundredthsOfADegree) {
  const WorstNormals tilted(1.0, 0.0005);  // 0.03 degrees
  EXPECT_GT(tilted.mean, 0.02);
  EXPECT_GT(tilted.surface, 0.01);
}

TEST(FitScan, SpikesAndDropOutsLeaveNoTrace) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RasterScan raster = whiteScan(seed);
    raster.noise = 2 * um;
    raster.spikes = 0.002;
    raster.drop_outs = 0.005;
    const FittedScan scan = fit(raster);
    EXPECT_EQ(scan.lines.size(), 41u) << "seed " << seed;
    EXPECT_EQ(scan.outline.polygons.size(), 1u);
    // Without spikes the residual is the noise; one spike of 0.2 mm among 200,000 samples adds 0.05 um to it, 0.02 %.
    EXPECT_NEAR(scan.line_sigma, raster.noise, 0.01 * raster.noise) << "seed " << seed;
    EXPECT_LE(accuracyOf(scan, NormalMode::weighted, raster).distance.largest, 3 * um);
  }
}

TEST(FitScan, WhiteNoiseCostsNoSamples) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RasterScan raster = whiteScan(seed);
    const FittedScan scan = fit(raster);
    std::size_t accounted = scan.samples_used;
    for (const Dropped& d : scan.dropped) accounted += d.count;
    EXPECT_EQ(accounted, scan.samples_in);
    const std::size_t lost =
        scan.samples_in - scan.samples_used - droppedFor(scan.dropped, "turn") - droppedFor(scan.dropped, "background");
    EXPECT_LT(static_cast<double>(lost), 0.001 * static_cast<double>(scan.samples_in));
    EXPECT_NEAR(scan.line_sigma, raster.noise,
                3.0 * raster.noise / std::sqrt(2.0 * static_cast<double>(scan.samples_used)) + 0.06 * um);
  }
}

TEST(FitScan, OutlineIsThePartWithinOneSpacing) {
  const RasterScan raster = whiteScan(2);
  const FittedScan scan = fit(raster);
  ASSERT_EQ(scan.outline.polygons.size(), 1u);
  const geometry::Frame T_truth_scan = raster.T_cloud_scan.inverse() * scan.T_cloud_scan;
  double area = 0.0;
  const auto& polygon = scan.outline.polygons[0];
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& p = polygon[i];
    const Eigen::Vector2d& q = polygon[(i + 1) % polygon.size()];
    area += 0.5 * (p.x() * q.y() - q.x() * p.y());
    const Vector3 corner = T_truth_scan * Vector3(p.x(), p.y(), 0.0);
    EXPECT_LE(std::min(std::abs(corner.x()), std::abs(corner.x() - 0.24)), raster.spacing + 25 * um);
  }
  EXPECT_NEAR(area, 0.24 * 0.16, 0.004 * 0.24);  // counter-clockwise, one pitch across
}

TEST(FitScan, SameResultForAnyNumberOfThreads) {
  RasterScan raster = whiteScan(3);
  raster.spikes = 0.002;
  const FittedScan one = fit(raster, {}, 1);
  const FittedScan three = fit(raster, {}, 3);
  ASSERT_EQ(one.lines.size(), three.lines.size());
  for (std::size_t i = 0; i < one.lines.size(); ++i) {
    EXPECT_EQ(one.lines[i].curve.control_points, three.lines[i].curve.control_points);
    EXPECT_EQ(one.lines[i].curve.knots, three.lines[i].curve.knots);
  }
  EXPECT_EQ(one.surface.control_points, three.surface.control_points);
  const auto points_one = orientLines(one, {}, NormalMode::weighted, 1).lines;
  const auto points_three = orientLines(one, {}, NormalMode::weighted, 3).lines;
  for (std::size_t i = 0; i < points_one.size(); ++i) {
    for (std::size_t k = 0; k < points_one[i].points.size(); ++k) {
      EXPECT_EQ(points_one[i].points[k].normal, points_three[i].points[k].normal);
    }
  }
}

TEST(FitScan, MovingTheCloudMovesTheResult) {
  RasterScan raster = whiteScan(4);
  raster.T_cloud_scan = geometry::Frame::Identity();
  const FittedScan here = fit(raster);
  const geometry::Frame T = makeFrame({0.3, -0.4, 0.2}, {-0.4, 0.3, 2.0});
  raster.T_cloud_scan = T;
  const FittedScan there = fit(raster);
  ASSERT_EQ(here.lines.size(), there.lines.size());
  for (std::size_t i = 0; i < here.lines.size(); ++i) {
    const Vector3 p = nurbs::pointAt(here.lines[i].curve, 0.01);
    // Coordinates are floats: 0.03 um at half a metre, and knots follow from them.
    EXPECT_LT((T * p - nurbs::pointAt(there.lines[i].curve, 0.01)).norm(), 0.5 * um);
  }
}

TEST(FitScan, StopsWhenAsked) {
  const std::atomic<bool> cancelled{true};
  const SPart part;
  const RasterScan raster = whiteScan(1);
  EXPECT_THROW(fitScan(scanRaster(raster, onTable(part, table)), -raster.T_cloud_scan.linear().col(2), {}, {}, 1,
                       Progress({}, &cancelled)),
               Interrupted);
}

TEST(FitScan, RefusesOptionsOutOfRange) {
  FitOptions options;
  options.lines.corner_angle = -1.0;
  expectInputError([&] { fit(whiteScan(1), options); }, "fit.corner_angle is -1 rad, must be in");
}

}  // namespace
}  // namespace scan_to_path::scan
