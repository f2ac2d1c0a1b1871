// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/clock_offset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "support/expect_input_error.h"
#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

using test::SensingCell;

constexpr double bar = 1e-4;  // [s]

EmulationOptions optionsOf(ErrorSet set, double offset, int seed) {
  EmulationOptions options;
  options.errors = errorPreset(set);
  options.errors.clock_offset = offset;
  options.seed = seed;
  return options;
}

/// The S part scanned with clocks that agree; scanned once for all tests.
const scan::SampleLog& agreeingScan(ErrorSet set, int seed) {
  static std::map<std::pair<ErrorSet, int>, scan::SampleLog> scans;
  const auto [entry, is_new] = scans.try_emplace({set, seed});
  if (is_new) entry->second = SensingCell().emulate(optionsOf(set, 0.0, seed)).log;
  return entry->second;
}

/// The log of the same scan with clocks `offset` apart: only stamps differ
/// (EmulateScan.ClockOffsetShiftsTheStampsOnly).
scan::SampleLog scanned(ErrorSet set, double offset, int seed) {
  scan::SampleLog log = agreeingScan(set, seed);
  for (auto& t : log.joint_time) t += std::max(0.0, offset);
  for (auto& t : log.sensor_time) t += std::max(0.0, offset) - offset;
  return log;
}

double largestError(ErrorSet set, double offset) {
  const SensingCell cell;
  double largest = 0.0;
  for (int seed = 1; seed <= 5; ++seed) {
    const auto estimate = cell.clockOffset(scanned(set, offset, seed));
    EXPECT_EQ(estimate.observability, Observability::observable) << estimate.reason;
    EXPECT_EQ(estimate.rows, 40);
    const double error = std::abs(estimate.offset - offset);
    EXPECT_LT(error, 4.0 * estimate.standard_error);  // the standard error is an honest one
    EXPECT_LT(estimate.standard_error, 2e-5);
    largest = std::max(largest, error);
  }
  return largest;
}

TEST(ClockOffset, AMillisecondIsFoundUnderWhiteNoise) { EXPECT_LE(largestError(ErrorSet::white, 1e-3), bar); }
TEST(ClockOffset, AMillisecondIsFoundUnderRealisticErrors) { EXPECT_LE(largestError(ErrorSet::realistic, 1e-3), bar); }
TEST(ClockOffset, NoOffsetIsFoundWhereThereIsNone) {
  EXPECT_LE(largestError(ErrorSet::white, 0.0), bar);
  EXPECT_LE(largestError(ErrorSet::realistic, 0.0), bar);
}

TEST(ClockOffset, TwinsMissTheBar) {
  const SensingCell cell;
  // Clocks that are a fifth more apart, and encoders whose clock goes a little fast: 0.2 ms over a tenth of the scan.
  EXPECT_GT(std::abs(cell.clockOffset(scanned(ErrorSet::realistic, 1.2e-3, 1)).offset - 1e-3), bar);
  auto log = scanned(ErrorSet::realistic, 1e-3, 1);
  const double begin = log.joint_time.front(), duration = log.joint_time.back() - begin;
  for (auto& t : log.joint_time) t += 2e-3 * (t - begin) / duration;
  EXPECT_GT(std::abs(cell.clockOffset(log).offset - 1e-3), bar);
}

TEST(ClockOffset, WithoutErrorsOnlyThePartsShapeIsLeft) {
  const SensingCell cell;
  for (const double offset : {0.0, -2.5e-3, 0.02}) {
    const auto estimate = cell.clockOffset(scanned(ErrorSet::none, offset, 1));
    // Third difference across 4 mm rows: 0.004 (pi / 0.16)^3 (4 mm)^3 = 2 um at most, of either sign in neighbouring
    // groups; it stays below 1 us of 2 v slope = 20 um/ms.
    EXPECT_NEAR(estimate.offset, offset, 1e-6);
  }
}

TEST(ClockOffset, StartIsAddedNotCounted) {
  const SensingCell cell;
  const auto log = scanned(ErrorSet::realistic, 1e-3, 2);
  const double from_zero = cell.clockOffset(log).offset;
  PlacementOptions placement;
  placement.clock_offset = 0.9e-3;
  EXPECT_NEAR(cell.clockOffset(log, placement).offset, from_zero, 2e-6);  // iterated to 1 us from either side
}

TEST(ClockOffset, CorrectedScansLieOnTheSurfaceAgain) {
  const SensingCell cell;
  const auto log = scanned(ErrorSet::none, 1e-3, 1);
  PlacementOptions placement;
  placement.clock_offset = cell.clockOffset(log).offset;
  const auto scan = cell.place(log, placement);
  for (std::size_t i = 0; i < scan.cloud.size(); i += 101) {
    const Vector3 p = cell.T_base_workpiece.inverse() * scan.cloud[i].getVector3fMap().cast<double>();
    // 1 us at 50 mm/s, and floats; ramps at the offset's fraction of a reading, 0.6 um at 4 ms, 0.04 um at 1 ms.
    EXPECT_LT((cell.scene->closestPoint(p).point - p).norm(), 0.05e-6 + 0.065e-6 + 0.04e-6);
  }
}

TEST(ClockOffset, UnevenPitchSlowJointsAndTurnedRowsAreNoObstacle) {
  SensingCell cell;
  EmulationOptions options = optionsOf(ErrorSet::realistic, 1e-3, 3);
  options.joint_rate = 250.0;
  options.raster.pitch = 0.003;
  options.raster.pitch_alternate = 0.005;
  EXPECT_NEAR(cell.clockOffset(cell.emulate(options).log).offset, 1e-3, bar);
  options.raster.row_angle = 0.5;
  cell.T_base_workpiece = geometry::makeFrame({0.8, -0.05, 0.42}, {0.02, -0.03, 0.4});
  EXPECT_NEAR(cell.clockOffset(cell.emulate(options).log).offset, 1e-3, bar);
}

TEST(ClockOffset, LongScansAreSampledNotReadWhole) {
  SensingCell cell;
  EmulationOptions options = optionsOf(ErrorSet::realistic, 1e-3, 4);
  options.raster.pitch = 0.001;  // 160 rows
  const auto estimate = cell.clockOffset(cell.emulate(options).log);
  EXPECT_LE(estimate.rows, 60);
  EXPECT_GE(estimate.rows, 50);
  EXPECT_NEAR(estimate.offset, 1e-3, bar);
}

void expectNotObservable(const SensingCell& cell, const EmulationOptions& options, Observability observability,
                         const std::string& why) {
  const auto estimate = cell.clockOffset(cell.emulate(options).log);
  EXPECT_EQ(estimate.observability, observability);
  EXPECT_THAT(estimate.reason, testing::HasSubstr(why));
  EXPECT_EQ(estimate.offset, 0.0);
}

TEST(ClockOffset, FlatPlatesTellNothing) {
  SensingCell cell;
  cell.scene = test::onTable(std::make_shared<geometry::FlatPart>(geometry::Rectangle{0.0, 0.24, 0.0, 0.16}));
  for (const auto set : {ErrorSet::none, ErrorSet::white, ErrorSet::realistic}) {
    expectNotObservable(cell, optionsOf(set, 1e-3, 1), Observability::few_slopes, "too few slopes along the rows");
  }
  // Rougher still: noise must not pass for slopes.
  EmulationOptions options = optionsOf(ErrorSet::white, 1e-3, 1);
  options.errors.noise_sigma = 100e-6;
  expectNotObservable(cell, options, Observability::few_slopes, "too few slopes along the rows");
}

/// Flat but for a band of waves along x, 12 mm wide.
class WaveBand : public geometry::HeightField {
public:
  explicit WaveBand(double middle)
      : HeightField({0.0, 0.08, 0.0, 0.16}, {-height, height, 2.0 * height * along * along}), middle_(middle) {}
  geometry::HeightJet jet(double x, double y) const override {
    geometry::HeightJet jet;
    const double v = across * (y - middle_);
    if (std::abs(v) >= 0.5 * M_PI) return jet;
    const double c = std::cos(v) * std::cos(v), s = std::sin(2.0 * v);
    jet.z = height * std::sin(along * x) * c;
    jet.zx = height * along * std::cos(along * x) * c;
    jet.zy = -height * across * std::sin(along * x) * s;
    jet.zxx = -along * along * jet.z;
    jet.zxy = -height * along * across * std::cos(along * x) * s;
    jet.zyy = -2.0 * height * across * across * std::sin(along * x) * std::cos(2.0 * v);
    return jet;
  }

private:
  static constexpr double height = 0.001;  // [m]
  static constexpr double along = 300.0;   // [rad/m]
  static constexpr double across = M_PI / 0.012;
  double middle_;
};

// Of a hundred rows blocks of eight are looked at, none of them in the band: it takes all rows to find it.
TEST(ClockOffset, SlopesInFewRowsAreLookedFor) {
  SensingCell cell;
  cell.rectangle = Eigen::AlignedBox2d(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.08, 0.16));
  EmulationOptions options = optionsOf(ErrorSet::white, 1e-3, 1);
  options.raster.pitch = 0.0016;
  options.raster.speed = 0.2;
  cell.scene = std::make_shared<WaveBand>(72.5 * options.raster.pitch);
  const auto estimate = cell.clockOffset(cell.emulate(options).log);
  EXPECT_EQ(estimate.rows, 100);
  EXPECT_GE(estimate.cells, 30) << estimate.reason;
  EXPECT_NE(estimate.observability, Observability::few_slopes);
}

TEST(ClockOffset, OneDirectionTellsNothing) {
  EmulationOptions options = optionsOf(ErrorSet::white, 1e-3, 1);
  options.raster.order = RasterOrder::one_way;
  expectNotObservable(SensingCell(), options, Observability::none, "all rows run in one direction");
}

TEST(ClockOffset, FewRowsTellNothing) {
  expectNotObservable(SensingCell::small(), optionsOf(ErrorSet::white, 1e-3, 1), Observability::none,
                      "too few neighbouring rows run to and fro in turn, 5 rows found, needs 6");
}

TEST(ClockOffset, AnUncertainEstimateSaysHowUncertain) {
  const SensingCell cell;
  ClockOffsetOptions strict;
  strict.max_standard_error = 1e-8;
  const auto estimate = estimateClockOffset(scanned(ErrorSet::realistic, 1e-3, 1), cell.robot, cell.encoders(),
                                            cell.laser, cell.T_tip_sensor, {}, strict);
  EXPECT_EQ(estimate.observability, Observability::uncertain);
  EXPECT_THAT(estimate.reason, testing::HasSubstr("the standard error is "));
  EXPECT_NEAR(estimate.offset, 1e-3, 4.0 * estimate.standard_error);
}

TEST(ClockOffset, BadInputIsNamed) {
  const SensingCell cell = SensingCell::small();
  const auto log = cell.emulate({}).log;
  ClockOffsetOptions options;
  options.cell = 0.0;
  const auto estimate = [&] {
    estimateClockOffset(log, cell.robot, cell.encoders(), cell.laser, cell.T_tip_sensor, {}, options);
  };
  test::expectInputError(estimate, "clock offset.cell is 0 m, must be in");
  options = {};
  options.max_rows = 1;
  test::expectInputError(estimate, "clock offset.max_rows is 1, must be in [8, 100000]");
}

}  // namespace
}  // namespace scan_to_path::sensing
