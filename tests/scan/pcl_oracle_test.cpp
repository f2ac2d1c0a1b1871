// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include <memory>

#include "../src/scan/row_neighbours.h"
#include "scan_to_path/scan/fit_scan.h"
#include "support/fitted_scans.h"
#include "support/raster_scan.h"
#include "support/scan_accuracy.h"

// PCL beside this package: where its methods work both must agree, where they cannot work only one may be right.

namespace scan_to_path::scan {
namespace {

using geometry::SPart;
using test::RasterScan;
using PclCloud = pcl::PointCloud<pcl::PointXYZ>;
using PclNormals = pcl::PointCloud<pcl::Normal>;

constexpr double degrees = 57.29577951308232;

Vector3 trueNormal(double x, double y) { return SPart().at(x, y).normal; }

PclCloud::Ptr pclCloud(const ScanCloud& cloud) {
  auto copy = std::make_shared<PclCloud>();
  for (const ScanPoint& p : cloud) copy->push_back({p.x, p.y, p.z});
  return copy;
}

pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> pclEstimation(const PclCloud::Ptr& cloud) {
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setViewPoint(0.12F, 0.08F, 100.0F);
  return estimation;
}

/// Mean angle between PCL's normals with k neighbours and the S part's [deg].
double pclMeanError(const PclCloud::Ptr& cloud, int k) {
  auto estimation = pclEstimation(cloud);
  estimation.setKSearch(k);
  PclNormals found;
  estimation.compute(found);
  test::Statistic angle;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Vector3 normal = found[i].getNormalVector3fMap().cast<double>();
    angle.add(degrees * geometry::angleBetween(normal, trueNormal((*cloud)[i].x, (*cloud)[i].y)));
  }
  return angle.mean();
}

/// A patch of 40 mm by 30 mm on the S part's crest, sampled alike in both directions, without noise. Rows are given:
/// their pitch is no longer than the way over which rows would be told from turns.
constexpr double dense = 0.0002;

ScanCloud densePatch() {
  RasterScan scan;
  scan.x_min = 0.04;
  scan.x_max = 0.08;
  scan.rows = test::evenRows(0.06, dense, 151);
  scan.spacing = dense;
  scan.turns = false;
  const SPart part;
  ScanCloud cloud = test::scanRaster(scan, test::freeStanding(part));
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud[i].line = static_cast<std::uint32_t>(i / 201);
  return cloud;
}

/// Our normals at samples of the dense patch away from its border.
std::vector<OrientedPoint> orientedSamples(const FittedScan& scan, NormalMode mode) {
  const NormalEstimator estimator(scan, mode);
  std::vector<OrientedPoint> points;
  for (int row = 10; row < 141; row += 10) {
    std::vector<double> parameters;  // the line's parameter is x: these are samples
    for (int k = 10; k < 191; k += 5) parameters.push_back(scan.lines[static_cast<std::size_t>(row)].begin + dense * k);
    const OrientedLine line = estimator.orient(row, parameters);
    points.insert(points.end(), line.points.begin(), line.points.end());
  }
  return points;
}

PclNormals pclNormalsAt(const std::vector<OrientedPoint>& points, const PclCloud::Ptr& surface, double radius) {
  auto places = std::make_shared<PclCloud>();
  for (const OrientedPoint& p : points) {
    places->push_back(
        {static_cast<float>(p.point.x()), static_cast<float>(p.point.y()), static_cast<float>(p.point.z())});
  }
  auto estimation = pclEstimation(places);
  estimation.setSearchSurface(surface);
  estimation.setRadiusSearch(radius);
  PclNormals found;
  estimation.compute(found);
  return found;
}

test::Statistic anglesBetween(const std::vector<OrientedPoint>& points, const PclNormals& normals) {
  test::Statistic angle;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 normal = normals[i].getNormalVector3fMap().cast<double>();
    angle.add(degrees * geometry::angleBetween(points[i].normal, normal));
  }
  return angle;
}

TEST(PclOracle, NormalsAgreeWhereSamplesLieAlikeInAllDirections) {
  const ScanCloud cloud = densePatch();
  const FittedScan scan = fitScan(cloud, -Vector3::UnitZ(), {}, {});
  ASSERT_EQ(scan.lines.size(), 151U);
  for (const NormalMode mode : {NormalMode::weighted, NormalMode::surface}) {
    const auto points = orientedSamples(scan, mode);
    ASSERT_EQ(points.size(), 14U * 37U);
    const auto angle = anglesBetween(points, pclNormalsAt(points, pclCloud(cloud), 0.001));
    // A plane through a disk of radius R on a cubic is tilted by z''' R^2 / 12: up to 359 /m^2 at R = 1 mm, 0.0017
    // degrees. A sample without its counterpart beyond the middle tilts it by up to 2 z'' R / N, with N = 78 samples
    // and a bend of 13.7 /m 0.020 degrees; slopes below 0.3 leave fewer than one of them on a rim so wide, z' z'' R^2 =
    // 4 um.
    constexpr double cubic = 0.0017;
    constexpr double unpaired = 0.020;
    EXPECT_LT(angle.mean(), 2.0 * cubic) << enumName(mode);
    EXPECT_LT(angle.largest, cubic + unpaired) << enumName(mode);
    RecordProperty(std::string(enumName(mode)) + "_mean_udeg", static_cast<int>(1e6 * angle.mean()));
    RecordProperty(std::string(enumName(mode)) + "_largest_udeg", static_cast<int>(1e6 * angle.largest));
    // Twin: the normals of the next points, 1 mm further on.
    auto shifted = points;
    std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
    EXPECT_GT(anglesBetween(shifted, pclNormalsAt(points, pclCloud(cloud), 0.001)).mean(), 0.1);
  }
}

TEST(PclOracle, OnScanLinesNearestNeighboursFailAndRowsDoNot) {
  RasterScan raster;
  raster.x_min = 0.0;
  raster.x_max = 0.24;
  raster.rows = test::evenRows(0.0, 0.004, 41);
  raster.spacing = 0.0001;
  raster.turns = false;
  raster.noise = 10e-6;
  const SPart part;
  const ScanCloud cloud = test::scanRaster(raster, test::freeStanding(part));
  const auto copy = pclCloud(cloud);
  for (const int k : {10, 20, 50}) {
    // All on one line: samples differ along it, by their noise in height and across not at all, so the direction
    // across passes for the normal (seed, Fig. 11).
    const double error = pclMeanError(copy, k);
    EXPECT_GT(error, 45.0) << "k = " << k;
    RecordProperty("pcl_k" + std::to_string(k) + "_mean_mdeg", static_cast<int>(1e3 * error));
  }
  EXPECT_LT(pclMeanError(copy, 100), 0.1);  // reaches the next rows: PCL itself, and this test, measure rightly
  const FittedScan scan = fitScan(cloud, -Vector3::UnitZ(), {}, {});
  ResampleOptions resample;
  resample.spacing = raster.spacing;
  const auto ours = [&](NormalMode mode) {
    const double mean = test::measureAccuracy(orientLines(scan, resample, mode).lines, scan, part).all.mean();
    RecordProperty(std::string(enumName(mode)) + "_mean_mdeg", static_cast<int>(1e3 * mean));
    return mean;
  };
  EXPECT_LT(ours(NormalMode::weighted), 0.02);  // acceptance bars
  EXPECT_LT(ours(NormalMode::surface), 0.01);
}

TEST(PclOracle, TheNearestPointOfAllOtherRowsIsOnANeighbour) {
  const auto height = [](double x, double y) { return 0.01 * std::sin(40.0 * x + 60.0 * y); };
  FittedScan scan;
  for (int row = 0; row < 6; ++row) {
    FittedLine line;
    line.row = row;
    line.curve = test::heightLine(height, 0.0, 0.08, 0.004 * row, 24, Frame::Identity());
    for (Vector3& p : line.curve.control_points) p.y() += 0.5 * p.x();  // the nearest is not at the same x
    line.end = 0.08;
    scan.lines.push_back(line);
  }
  const ScanTables tables = makeTables(scan);
  constexpr double step = 20e-6;
  for (int row = 0; row < 6; ++row) {
    auto others = std::make_shared<PclCloud>();
    for (int other = 0; other < 6; ++other) {
      std::size_t hint = 0;
      for (int k = 0; other != row && k <= 4000; ++k) {
        const Vector3 p = tables.lines[static_cast<std::size_t>(other)].point(step * k, hint);
        others->push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
      }
    }
    pcl::search::KdTree<pcl::PointXYZ> tree;
    tree.setInputCloud(others);
    RowNeighbours neighbours(tables, row, 0.0);
    for (double x = 0.01; x < 0.07; x += 0.0005) {
      ASSERT_TRUE(neighbours.lineAt(0, x));
      const Vector3 p = neighbours.pointAt(0, x);
      double found = 1e300;
      double same_x = 1e300;
      for (const int side : {-1, 1}) {
        if (!neighbours.lineAt(side, x)) continue;
        found = std::min(found, (neighbours.nearestTo(side, p) - p).norm());
        same_x = std::min(same_x, (neighbours.pointAt(side, x) - p).norm());
      }
      pcl::Indices index(1);
      std::vector<float> squared(1);
      tree.nearestKSearch({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())}, 1, index,
                          squared);
      const Vector3 q = (*others)[static_cast<std::size_t>(index[0])].getVector3fMap().cast<double>();
      // The sample next to the foot point is at most half a step of 20 to 25 um beside it: (12 um)^2 / (2 * 3.4 mm) =
      // 21 nm farther; coordinates in floats add 4 nm each.
      EXPECT_NEAR((q - p).norm(), found, 30e-9) << row << " " << x;
      EXPECT_GT(same_x - found, 1e-4);  // twin
    }
  }
}

}  // namespace
}  // namespace scan_to_path::scan
