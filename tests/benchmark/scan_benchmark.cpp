// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <pcl/features/normal_3d.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <memory>

#include "scan_to_path/scan/fit_scan.h"
#include "scan_to_path/scan/sample_log.h"
#include "support/raster_scan.h"
#include "support/scan_accuracy.h"

namespace {

using namespace scan_to_path;

/// The S part's height function over 0.8 m by 0.5 m.
class WidePart : public geometry::HeightField {
public:
  WidePart() : HeightField({0.0, 0.8, 0.0, 0.5}, {-0.03, 0.03, 100.0}) {}
  geometry::HeightJet jet(double x, double y) const override { return part_.jet(x, y); }

private:
  geometry::SPart part_;
};

const WidePart& part() {
  static const WidePart wide;
  return wide;
}

/// 1,000,000 points, 4 mm by 0.1 mm, sensor noise 10 um.
const scan::ScanCloud& cloud() {
  static const scan::ScanCloud points = [] {
    test::RasterScan scan;
    scan.x_min = 0.0;
    scan.x_max = 0.8;
    scan.rows = test::evenRows(0.0, 0.004, 125);
    scan.spacing = 0.0001;
    scan.turns = false;
    scan.noise = 10e-6;
    return test::scanRaster(scan, test::freeStanding(part()));
  }();
  return points;
}

const scan::FittedScan& fitted() {
  static const scan::FittedScan scan = scan::fitScan(cloud(), -scan::Vector3::UnitZ(), {}, {});
  return scan;
}

constexpr double spacing = 0.0001;

void report(benchmark::State& state, const std::vector<scan::OrientedLine>& lines, const scan::FittedScan& scan) {
  const test::ScanAccuracy accuracy = test::measureAccuracy(lines, scan, part());
  state.counters["points"] = static_cast<double>(accuracy.all.count);
  state.counters["mean_deg"] = accuracy.all.mean();
  state.counters["max_deg"] = accuracy.all.largest;
}

/// Resampling and normals on lines that are fitted already.
void normals(benchmark::State& state) {
  scan::ResampleOptions resample;
  resample.spacing = spacing;
  const auto mode = static_cast<scan::NormalMode>(state.range(0));
  const scan::FittedScan& scan = fitted();
  scan::OrientedScan oriented;
  for (auto _ : state) {
    state.PauseTiming();
    oriented = {};
    state.ResumeTiming();
    oriented = scan::orientLines(scan, resample, mode);
  }
  report(state, oriented.lines, scan);
  state.SetLabel(scan_to_path::enumName(mode));
}

/// Line fit and normals of mode weighted, as PCL's tree and normals: from a clean part, with as many threads.
void fitAndNormals(benchmark::State& state) {
  scan::ResampleOptions resample;
  resample.spacing = spacing;
  scan::FitOptions options;
  options.with_surface = false;
  const int threads = static_cast<int>(state.range(0));
  const scan::SampleRows rows = scan::cleanRows(cloud(), -scan::Vector3::UnitZ(), {});
  scan::FittedScan scan;
  scan::OrientedScan oriented;
  for (auto _ : state) {
    scan = scan::fitRows(rows, options, threads);
    oriented = scan::orientLines(scan, resample, scan::NormalMode::weighted, threads);
  }
  report(state, oriented.lines, scan);
}

/// Everything from the raw cloud: rows, filters, line fit, normals of mode weighted.
void cloudToNormals(benchmark::State& state) {
  scan::ResampleOptions resample;
  resample.spacing = spacing;
  scan::FitOptions options;
  options.with_surface = state.range(0) != 0;
  scan::FittedScan scan;
  scan::OrientedScan oriented;
  for (auto _ : state) {
    scan = scan::fitScan(cloud(), -scan::Vector3::UnitZ(), {}, options);
    oriented = scan::orientLines(scan, resample, scan::NormalMode::weighted);
  }
  report(state, oriented.lines, scan);
  state.SetLabel(options.with_surface ? "with surface" : "lines only");
}

const pcl::PointCloud<pcl::PointXYZ>::Ptr& pclCloud() {
  static const pcl::PointCloud<pcl::PointXYZ>::Ptr points = [] {
    auto copy = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (const scan::ScanPoint& p : cloud()) copy->push_back({p.x, p.y, p.z});
    return copy;
  }();
  return points;
}

void reportPcl(benchmark::State& state, const pcl::PointCloud<pcl::Normal>& found) {
  test::Statistic angle;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const geometry::HeightJet jet = part().jet((*pclCloud())[i].x, (*pclCloud())[i].y);
    const geometry::Vector3 normal(found[i].normal_x, found[i].normal_y, found[i].normal_z);
    if (!std::isfinite(normal.sum())) continue;
    angle.add(57.29577951308232 * geometry::angleBetween(normal, geometry::Vector3(-jet.zx, -jet.zy, 1.0)));
  }
  state.counters["points"] = static_cast<double>(angle.count);
  state.counters["mean_deg"] = angle.mean();
  state.counters["max_deg"] = angle.largest;
}

/// PCL's normals with k neighbours, tree included. The tree need not sort what it finds, which is its faster setting.
template <class Estimation>
void pclNormals(benchmark::State& state) {
  pcl::PointCloud<pcl::Normal> found;
  pclCloud();
  for (auto _ : state) {
    Estimation estimation;
    estimation.setInputCloud(pclCloud());
    estimation.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false));
    estimation.setKSearch(static_cast<int>(state.range(0)));
    estimation.setViewPoint(0.4F, 0.25F, 100.0F);
    estimation.compute(found);
  }
  reportPcl(state, found);
}

scan::SampleLog millionRows() {
  scan::SampleLog log;
  for (int joint = 1; joint <= 6; ++joint) log.joint_names.push_back("joint_" + std::to_string(joint));
  for (int i = 0; i < 1000000; ++i) {
    log.joint_time.push_back(0.001 * i);
    log.sensor_time.push_back(0.001 * i);
    for (int joint = 0; joint < 6; ++joint) log.counts.push_back(1234567.0 + 37.0 * i * (joint - 2));
    log.voltage.push_back(5.0 * std::sin(0.001 * i));
  }
  return log;
}

void parseLog(benchmark::State& state) {
  const std::string text = scan::formatSampleLog(millionRows());
  for (auto _ : state) benchmark::DoNotOptimize(scan::parseSampleLog(text, "log"));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}

void formatLog(benchmark::State& state) {
  const scan::SampleLog log = millionRows();
  for (auto _ : state) benchmark::DoNotOptimize(scan::formatSampleLog(log));
}

/// Numbers of neighbours that PCL is tried with, once each: the larger ones take long.
void onceForEachCount(benchmark::internal::Benchmark* normals) {
  for (const int neighbours : {10, 20, 50, 100, 200, 400}) normals->Arg(neighbours);
  normals->Iterations(1);
}

BENCHMARK(parseLog)->Unit(benchmark::kMillisecond);
BENCHMARK(formatLog)->Unit(benchmark::kMillisecond);
BENCHMARK(normals)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(fitAndNormals)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(cloudToNormals)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(pclNormals<pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal>>)
    ->Name("pclNormals")
    ->Apply(onceForEachCount)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(pclNormals<pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal>>)
    ->Name("pclNormalsOmp")
    ->Apply(onceForEachCount)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
