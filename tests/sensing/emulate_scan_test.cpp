// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/emulate_scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_input_error.h"
#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

using test::SensingCell;

std::vector<double> distancesOf(const scan::SampleLog& log) {
  std::vector<double> distances;
  for (const double voltage : log.voltage) {
    distances.push_back(distanceFromVoltage({}, voltage).value_or(std::nan("")));
  }
  return distances;
}

/// Range readings with an error less those without, where both are readings.
std::vector<double> rangeErrors(const SensingCell& cell, const EmulationOptions& options) {
  EmulationOptions exact = options;
  exact.errors = {};
  const auto truth = distancesOf(cell.emulate(exact).log), read = distancesOf(cell.emulate(options).log);
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (std::isfinite(truth[i] + read[i])) errors.push_back(read[i] - truth[i]);
  }
  return errors;
}

double rmsOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void expectSameLog(const scan::SampleLog& a, const scan::SampleLog& b) {
  EXPECT_EQ(a.joint_names, b.joint_names);
  EXPECT_EQ(a.joint_time, b.joint_time);
  EXPECT_EQ(a.counts, b.counts);
  EXPECT_EQ(a.sensor_time, b.sensor_time);
  EXPECT_EQ(a.voltage, b.voltage);
}

TEST(EmulateScan, SPartTakesFortyRowsAndIsSeenWhole) {
  const auto scan = SensingCell().emulate({});
  EXPECT_EQ(scan.rows, 40);
  EXPECT_NEAR(scan.duration, 207.07, 0.01);  // 40 rows of 0.25 m at 50 mm/s and 39 steps of 4 mm, with their ramps
  EXPECT_EQ(scan.log.voltage.size(), 207071U);
  EXPECT_EQ(scan.log.counts.size(), 6 * scan.log.joint_time.size());
  EXPECT_EQ(scan.range.samples, scan.log.voltage.size());
  EXPECT_EQ(scan.range.too_near + scan.range.too_far + scan.range.nothing, 0U);
  EXPECT_NEAR(scan.range.farthest, 0.104, 1e-9);  // the table
  EXPECT_THAT(scan.log.joint_names,
              testing::ElementsAre("joint_1", "joint_2", "joint_3", "joint_4", "joint_5", "joint_6"));
}

TEST(EmulateScan, NoiseOnTheLogHasItsSigma) {
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::white);
  const auto errors = rangeErrors(SensingCell::small(), options);
  const double bar = 3.0 / std::sqrt(2.0 * static_cast<double>(errors.size()));
  EXPECT_NEAR(rmsOf(errors) / 10e-6, 1.0, bar);
}

TEST(EmulateScan, DriftOnTheLogIsSlowAndOfItsSize) {
  SensingCell cell = SensingCell::small();
  cell.scene = std::make_shared<geometry::Plane>();
  EmulationOptions options;
  options.sample_rate = options.joint_rate = 20.0;
  options.errors.drift_sigma = 20e-6 / 3.0;
  std::vector<double> all;
  for (options.seed = 1; options.seed <= 30; ++options.seed) {
    const auto errors = rangeErrors(cell, options);
    all.insert(all.end(), errors.begin(), errors.end());
    // One twentieth of a second later it has moved by sqrt(2) sigma / 20 s / 20 on average; six times that never.
    for (std::size_t i = 1; i < errors.size(); ++i) {
      EXPECT_LT(std::abs(errors[i] - errors[i - 1]), 6.0 * std::sqrt(2.0) * options.errors.drift_sigma / 400.0);
    }
  }
  // 30 scans of 26 s, about 1.7 independent values each: standard error sqrt(1 / (2 * 50)) of the standard deviation.
  EXPECT_NEAR(rmsOf(all) / options.errors.drift_sigma, 1.0, 3.0 * 0.1);
}

TEST(EmulateScan, DriftLeavesTheEncodersAlone) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  const auto still = cell.emulate(options);
  options.errors.drift_sigma = 1e-5;
  const auto drifting = cell.emulate(options);
  EXPECT_EQ(still.log.counts, drifting.log.counts);
  EXPECT_NE(still.log.voltage, drifting.log.voltage);
}

TEST(EmulateScan, EncodersCountWholeCounts) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  const auto exact = cell.emulate(options).log.counts;
  options.errors.quantise_encoders = true;
  const auto whole = cell.emulate(options).log.counts;
  double square = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_EQ(whole[i], std::round(exact[i]));
    square += (whole[i] - exact[i]) * (whole[i] - exact[i]);
  }
  // A uniform rounding error, sqrt(1/12): joints 4 and 6 barely move, so take a wide margin, but neither 0 nor 1.
  EXPECT_NEAR(std::sqrt(square / static_cast<double>(exact.size())), std::sqrt(1.0 / 12.0), 0.1);
}

TEST(EmulateScan, DropoutsAndSpikesOnTheLogHaveTheirShares) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::realistic);
  const auto log = cell.emulate(options).log;
  const double n = static_cast<double>(log.voltage.size());
  double dropouts = 0.0;
  for (const double distance : distancesOf(log)) dropouts += std::isnan(distance) ? 1.0 : 0.0;
  // Binomial; besides, a spike may leave the range: 2 in 1000 samples, 2.6 mm on average of 50.
  EXPECT_NEAR(dropouts, n * 0.005, 3.0 * std::sqrt(n * 0.005) + n * 0.002 * 0.1);
  double spikes = 0.0;
  for (const double error : rangeErrors(cell, options)) spikes += std::abs(error) > 0.15e-3 ? 1.0 : 0.0;
  EXPECT_NEAR(spikes, n * 0.002, 3.0 * std::sqrt(n * 0.002) + 10.0);  // five rows have ten edges to mix at
}

TEST(EmulateScan, EdgesMixOverTheSpot) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.sample_rate = options.joint_rate = 10000.0;  // 5 um apart
  options.errors.spot_diameter = 50e-6;
  int mixed = 0;
  for (const double error : rangeErrors(cell, options)) mixed += std::abs(error) > 0.1e-3 ? 1 : 0;
  // Five rows with two edges each, 50 um or ten samples wide; the rim's light is weak.
  EXPECT_GE(mixed, 70);
  EXPECT_LE(mixed, 110);
}

TEST(EmulateScan, ClockOffsetShiftsTheStampsOnly) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  const auto plain = cell.emulate(options).log;
  for (const double offset : {0.001, -0.001, 0.0000123}) {
    options.errors.clock_offset = offset;
    const auto log = cell.emulate(options).log;
    EXPECT_EQ(log.voltage, plain.voltage);
    EXPECT_EQ(log.counts, plain.counts);
    for (std::size_t i = 0; i < log.sensor_time.size(); i += 100) {
      EXPECT_NEAR(log.joint_time[i] - log.sensor_time[i], offset, 0.5e-6 + 1e-12);
    }
    EXPECT_GE(std::min(log.sensor_time.front(), log.joint_time.front()), 0.0);
    PlacementOptions placement;
    placement.clock_offset = std::round(offset * 1e6) / 1e6;
    const auto truth = cell.place(plain), scan = cell.place(log, placement);
    ASSERT_GE(scan.cloud.size() + 1, truth.cloud.size());
    // Stamps off by rounding are interpolated to: 1 ns more than two floats' rounding.
    EXPECT_LT((scan.cloud[5000].getVector3fMap() - truth.cloud[5000].getVector3fMap()).norm(), 2e-7F);
  }
}

TEST(EmulateScan, TimesLieOnTheMicrosecondGrid) {
  EmulationOptions options;
  options.sample_rate = 700.0;
  options.joint_rate = 250.0;
  const auto log = SensingCell::small().emulate(options).log;
  for (const auto* times : {&log.sensor_time, &log.joint_time}) {
    for (std::size_t i = 0; i < times->size(); ++i) {
      EXPECT_EQ((*times)[i], static_cast<double>(std::llround((*times)[i] * 1e6)) / 1e6);
      if (i > 0) {
        ASSERT_GT((*times)[i], (*times)[i - 1]);
      }
    }
  }
  EXPECT_NEAR(log.sensor_time[700], 1.0, 1e-12);
  EXPECT_NEAR(log.joint_time[250], 1.0, 1e-12);
}

TEST(EmulateScan, SameSeedSameBytesWithAnyNumberOfThreads) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::realistic);
  const auto one = cell.emulate(options, 1).log;
  expectSameLog(one, cell.emulate(options, 1).log);
  expectSameLog(one, cell.emulate(options, 2).log);
  expectSameLog(one, cell.emulate(options, 5).log);
  options.seed = 2;
  EXPECT_NE(one.voltage, cell.emulate(options).log.voltage);
  EXPECT_EQ(one.counts, cell.emulate(options).log.counts);
}

TEST(EmulateScan, MovingTheWorkpieceMovesTheCloud) {
  SensingCell cell = SensingCell::small();
  const auto before = cell.place(cell.emulate({}).log);
  const Frame T_before = cell.T_base_workpiece;
  cell.T_base_workpiece = geometry::makeFrame({0.78, 0.1, 0.4}, {0.05, -0.08, 0.3});
  const auto after = cell.place(cell.emulate({}).log);
  const Frame T_after_before = cell.T_base_workpiece * T_before.inverse();
  ASSERT_EQ(after.cloud.size(), before.cloud.size());
  for (std::size_t i = 0; i < before.cloud.size(); i += 13) {
    const Vector3 p = before.cloud[i].getVector3fMap().cast<double>();
    // Floats below 2 m, twice.
    EXPECT_LT((T_after_before * p - after.cloud[i].getVector3fMap().cast<double>()).norm(), 2e-7);
  }
  EXPECT_LT((after.mean_beam - T_after_before.linear() * before.mean_beam).norm(), 1e-9);
}

TEST(EmulateScan, OneWayScansHaveGaps) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.raster.order = RasterOrder::one_way;
  const auto scan = cell.emulate(options);
  int gaps = 0;
  for (std::size_t i = 1; i < scan.log.sensor_time.size(); ++i) {
    gaps += scan.log.sensor_time[i] - scan.log.sensor_time[i - 1] > 1.0 ? 1 : 0;
  }
  EXPECT_EQ(gaps, scan.rows - 1);
  EXPECT_EQ(cell.place(scan.log).cloud.size(), scan.log.sensor_time.size());
}

TEST(EmulateScan, ReliefBeyondTheRangeIsReported) {
  SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.raster.height = 0.074;  // 74 - 24 - … : the part's crests come nearer than 55 mm, the table stays
  const auto near = cell.emulate(options);
  EXPECT_GT(near.range.too_near, 0U);
  EXPECT_EQ(near.range.too_far, 0U);
  EXPECT_LT(near.range.nearest, 0.055);
  options.raster.height = 0.09;  // the table and the part's troughs go beyond 105 mm
  const auto far = cell.emulate(options);
  EXPECT_GT(far.range.too_far, 0U);
  EXPECT_EQ(far.range.too_near, 0U);
  EXPECT_GT(far.range.farthest, 0.105);
  for (const auto* scan : {&near, &far}) {
    const auto placed = cell.place(scan->log);
    EXPECT_EQ(placed.cloud.size() + scan->range.too_near + scan->range.too_far, scan->range.samples);
  }
  cell.scene = std::make_shared<geometry::SPart>();
  const auto alone = cell.emulate({});
  EXPECT_NEAR(static_cast<double>(alone.range.nothing), 5.0 * 2.0 * (5.0 - 1.25) * 20.0, 1500.0);  // overscan, ramps
}

TEST(EmulateScan, ReportsProgressAndCanBeCancelled) {
  const SensingCell cell = SensingCell::small();
  std::vector<std::string> stages;
  double before = 0.0;
  cell.emulate({}, 1, Progress([&](const std::string& stage, double fraction) {
                 if (stages.empty() || stages.back() != stage) {
                   stages.push_back(stage);
                   before = 0.0;
                 }
                 EXPECT_GE(fraction, before);
                 EXPECT_LE(fraction, 1.0);
                 before = fraction;
               }));
  EXPECT_THAT(stages, testing::ElementsAre("planning the scan", "scanning", "reading encoders"));
  std::atomic<bool> is_cancelled{false};
  const Progress cancelling([&](const std::string& stage, double) { is_cancelled = stage == "scanning"; },
                            &is_cancelled);
  EXPECT_THROW(cell.emulate({}, 2, cancelling), Interrupted);
}

TEST(EmulateScan, BadInputIsNamed) {
  SensingCell cell = SensingCell::small();
  const auto expectError = [&cell](auto&& spoil, const std::string& part) {
    EmulationOptions options;
    spoil(options);
    test::expectInputError([&] { cell.emulate(options); }, part);
  };
  expectError([](auto& o) { o.raster.pitch = -0.004; }, "emulate.raster.pitch is -0.004 m, must be in");
  expectError([](auto& o) { o.raster.acceleration = 0.0; }, "emulate.raster.acceleration is 0 m/s^2");
  expectError([](auto& o) { o.errors.spike_rate = 2.0; }, "emulate.errors.spike_rate is 2");
  expectError([](auto& o) { o.errors.spike_max = 0.0; }, "errors: spike_max is 0.000000 m");
  expectError([](auto& o) { o.sample_rate = 0.0; }, "emulate.sample_rate is 0 1/s");
  expectError([](auto& o) { o.joint_rate = std::nan(""); }, "emulate.joint_rate is nan");
  expectError([](auto& o) { o.seed = -1; }, "emulate.seed is -1");
  cell.laser.distance_max = 0.01;
  expectError([](auto&) {}, "laser: distance_max is 0.010000 m");
}

}  // namespace
}  // namespace scan_to_path::sensing
