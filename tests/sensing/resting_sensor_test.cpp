// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/resting_sensor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/text.h"
#include "scan_to_path/geometry/scene.h"
#include "support/expect_input_error.h"
#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

using test::SensingCell;

/// Five rows of the S part on its table, as a file holds them.
scan::SampleLog restScan(ErrorSet set, int seed = 1) {
  EmulationOptions options;
  options.errors = errorPreset(set);
  options.seed = seed;
  return scan::parseSampleLog(scan::formatSampleLog(SensingCell::small().emulate(options).log), "samples.csv");
}

scan::SampleLog saturated(scan::SampleLog log, double low, double high) {
  for (double& voltage : log.voltage) voltage = std::clamp(voltage, low, high);
  return log;
}

/// Every voltage for `samples` samples.
scan::SampleLog slow(scan::SampleLog log, std::size_t samples) {
  for (std::size_t i = 0; i < log.voltage.size(); ++i) log.voltage[i] = log.voltage[i - i % samples];
  return log;
}

void expectMeasuring(const scan::SampleLog& log, const PointLaserOptions& laser = {}) {
  EXPECT_NO_THROW(checkRestingSensor(log, laser));
}

constexpr double crest = -4.07;  // [V], of the highest of the five rows, to 0.01 V; the table is at 4.8 V

TEST(RestingSensor, AnOutputThatSaturatesWithinTheRangeIsRefused) {
  for (const ErrorSet set : {ErrorSet::white, ErrorSet::realistic}) {
    const auto log = restScan(set);
    expectMeasuring(log);
    for (const double depth : {0.01, 0.1, 1.0}) {  // 50 um to 5 mm cut off
      const auto low = saturated(log, crest + depth, 10.0), high = saturated(log, -10.0, 4.8 - depth);
      test::expectInputError([&] { checkRestingSensor(low, {}); }, "the sensor rests at " + fixed(crest + depth, 6));
      test::expectInputError([&] { checkRestingSensor(high, {}); }, "the sensor rests at " + fixed(4.8 - depth, 6));
    }
  }
}

TEST(RestingSensor, AHeldValueIsRefusedWhereverItLies) {
  auto log = restScan(ErrorSet::realistic);
  std::fill_n(log.voltage.begin() + 3000, 50, 1.25);
  expectMeasuring(log);
  std::fill_n(log.voltage.begin() + 3000, 51, 1.25);
  test::expectInputError([&] { checkRestingSensor(log, {}); }, "for 51 samples");
  test::expectInputError([&] { checkRestingSensor(log, {}); }, "sample 3000 at 3.000000 s");
  PointLaserOptions any;
  any.max_repeats = 0;
  expectMeasuring(log, any);
  // At the ends of the output it is no return, and may last.
  std::fill_n(log.voltage.begin() + 3000, 500, 4.998);
  expectMeasuring(log);
}

// Without noise a plate and a table say the same all the time.
TEST(RestingSensor, FlatPartsWithoutNoiseAreMeasured) {
  expectMeasuring(restScan(ErrorSet::none));
  SensingCell plate = SensingCell::small();
  plate.scene = std::make_shared<geometry::FlatPart>(geometry::Rectangle{0.0, 0.24, 0.0, 0.16});
  expectMeasuring(plate.emulate({}).log);
}

/// A plate measured with noise, through a converter of that many bits. It lies 1 mrad askew, 0.1 mm or more over its
/// length, as level to a step of every converter it would measure the same all over, as a dead sensor does.
scan::SampleLog plateThroughConverter(double noise, int bits) {
  SensingCell plate = SensingCell::small();
  plate.scene = std::make_shared<geometry::PosedSurface>(
      std::make_shared<geometry::FlatPart>(geometry::Rectangle{0.0, 0.24, 0.0, 0.16}),
      geometry::makeFrame(geometry::Vector3::Zero(), {0.0, 1e-3, 0.0}));
  EmulationOptions options;
  options.errors.noise_sigma = noise;
  options.errors.converter_bits = bits;
  return plate.emulate(options).log;
}

// A converter too coarse for the noise repeats itself on a plate: steps of 12 um and noise of 2 um, and all between.
TEST(RestingSensor, CoarseConvertersMayRepeatThemselves) {
  for (const int bits : {8, 10, 12, 13, 14, 15, 16, 18}) {
    for (const double noise : {0.2e-6, 1e-6, 2e-6, 10e-6}) expectMeasuring(plateThroughConverter(noise, bits));
  }
}

TEST(RestingSensor, SlowSensorsMayRepeatThemselves) {
  for (const std::size_t samples : {2U, 5U, 20U, 60U}) {
    expectMeasuring(slow(restScan(ErrorSet::white), samples));
    expectMeasuring(slow(restScan(ErrorSet::realistic), samples));
  }
  // A sensor half as fast as its log must rest for twice as many samples.
  auto log = slow(restScan(ErrorSet::white), 2);
  std::fill_n(log.voltage.begin() + 3000, 100, 1.25);
  expectMeasuring(log);
  std::fill_n(log.voltage.begin() + 3000, 102, 1.25);
  test::expectInputError([&] { checkRestingSensor(log, {}); }, "(limit 100, cell.laser.max_repeats)");
}

// Not even over a plate without noise does nothing change.
TEST(RestingSensor, ADeadSensorIsNoPlate) {
  auto log = restScan(ErrorSet::none);
  std::fill(log.voltage.begin(), log.voltage.end(), 1.0);
  const std::string samples = std::to_string(log.voltage.size());
  test::expectInputError([&] { checkRestingSensor(log, {}); },
                         "all " + samples + " samples that measure say 1.000000 V");
  PointLaserOptions any;
  any.max_repeats = 0;
  expectMeasuring(log, any);
  // What measures nothing tells nothing.
  log.voltage[1000] = std::nan("");
  log.voltage[2000] = 4.999;
  test::expectInputError([&] { checkRestingSensor(log, {}); }, "samples that measure say 1.000000 V");
  log.voltage[3000] = 1.001;
  expectMeasuring(log);
}

TEST(RestingSensor, ShortAndEmptyLogsTellNothing) {
  expectMeasuring({});
  scan::SampleLog log;
  for (int i = 0; i < 200; ++i) {
    log.sensor_time.push_back(i * 1e-3);
    log.voltage.push_back(i < 100 ? 1.0 + 1e-3 * (i % 7) : 2.0);
  }
  expectMeasuring(log);
}

}  // namespace
}  // namespace scan_to_path::sensing
