// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/sample_placer.h"

#include <gmock/gmock.h>

#include <limits>

#include "moving_sensor.h"
#include "support/expect_input_error.h"

namespace scan_to_path_ros {
namespace {

using scan_to_path::test::expectInputError;
using test::MovingSensor;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Coordinates are floats below 1 m: half a unit in the last place is 3e-8 m.
constexpr double rounding = 6e-8;

class SamplePlacerTest : public ::testing::Test {
protected:
  void addMount() { placer_.addTransform(MovingSensor::mountTransform(), true); }
  void addReadings(int first, int last) {  // every 10 ms
    for (int i = first; i <= last; ++i) placer_.addTransform(MovingSensor::linkTransform(0.01 * i), false);
  }
  /// Eleven readings, and a sensor that measures from `nearest` to `farthest` [m].
  void startWithRange(double nearest, double farthest) {
    SamplePlacerOptions options;
    options.range_min = nearest;
    options.range_max = farthest;
    placer_.restart(options);
    addMount();
    addReadings(0, 10);
  }
  std::size_t droppedFor(const std::string& reason) const {
    for (const auto& entry : placer_.dropped()) {
      if (entry.reason == reason) return entry.count;
    }
    return 0;
  }
  std::size_t placed() const { return placer_.cloud().size(); }
  void expectPoint(std::size_t i, double t, double range) const {
    const auto& point = placer_.cloud()[i];
    const auto truth = MovingSensor::pointAt(t, range);
    EXPECT_NEAR(point.x, truth.x(), rounding);
    EXPECT_NEAR(point.y, truth.y(), rounding);
    EXPECT_NEAR(point.z, truth.z(), rounding);
    EXPECT_EQ(point.line, core::scan::no_line);
  }
  /// Every sample is placed, dropped for a reason, or still waits.
  void expectAllCounted() const {
    std::size_t dropped = 0;
    for (const auto& entry : placer_.dropped()) dropped += entry.count;
    EXPECT_EQ(placer_.samplesIn(), placed() + dropped + placer_.waiting());
  }
  SamplePlacer placer_{SamplePlacerOptions()};
};

TEST_F(SamplePlacerTest, PlacesEachSampleAtItsOwnStamp) {
  addMount();
  addReadings(0, 10);
  placer_.addSamples(MovingSensor::samples(0.02, {0.0, 0.001, 0.0075}, {0.10, 0.11, 0.12}));
  ASSERT_EQ(placed(), 3U);
  expectPoint(0, 0.02, 0.10);
  expectPoint(1, 0.021, 0.11);
  expectPoint(2, 0.0275, 0.12);
  EXPECT_EQ(placer_.cloud()[0].time, 0.0);
  EXPECT_EQ(placer_.cloud()[2].time, 0.0075);  // since the first sample
  EXPECT_EQ(placer_.acknowledged(), MovingSensor::stamp(0.0275));
  expectAllCounted();
}

TEST_F(SamplePlacerTest, AnotherStampWouldBeSeen) {
  // The mutation: the pose of the nearest reading, 5 ms off, instead of the sample's own.
  EXPECT_GT((MovingSensor::pointAt(0.025, 0.1) - MovingSensor::pointAt(0.02, 0.1)).norm(), 1000 * rounding);
}

TEST_F(SamplePlacerTest, WaitsForLateTransforms) {
  addMount();
  addReadings(0, 2);
  placer_.addSamples(MovingSensor::samples(0.015, {0.0, 0.01, 0.02}, {0.1, 0.1, 0.1}));
  EXPECT_EQ(placed(), 1U);
  EXPECT_EQ(placer_.waiting(), 2U);
  EXPECT_EQ(placer_.acknowledged(), MovingSensor::stamp(0.015));
  addReadings(3, 4);
  EXPECT_EQ(placed(), 3U);
  expectPoint(2, 0.035, 0.1);
  expectAllCounted();
}

/// An emulator that waits for the acknowledgement says nothing more.
TEST_F(SamplePlacerTest, PlacesWhatWaitedForTheMount) {
  addReadings(0, 10);
  placer_.addSamples(MovingSensor::samples(0.02, {0.0, 0.001}, {0.10, 0.11}));
  EXPECT_EQ(placed(), 0U);
  addMount();
  ASSERT_EQ(placed(), 2U);
  expectPoint(1, 0.021, 0.11);
  EXPECT_EQ(placer_.acknowledged(), MovingSensor::stamp(0.021));
}

TEST_F(SamplePlacerTest, TakesTransformsOutOfOrder) {
  addMount();
  addReadings(0, 1);
  placer_.addSamples(MovingSensor::samples(0.015, {0.0, 0.01}, {0.1, 0.1}));
  placer_.addTransform(MovingSensor::linkTransform(0.03), false);
  placer_.addTransform(MovingSensor::linkTransform(0.02), false);
  ASSERT_EQ(placed(), 2U);
  expectPoint(0, 0.015, 0.1);  // the motion is what tf2 interpolates, whichever readings are there
  expectPoint(1, 0.025, 0.1);
}

TEST_F(SamplePlacerTest, GivesUpOnTransformsThatNeverCome) {
  addMount();
  addReadings(0, 2);
  placer_.addSamples(MovingSensor::sample(0.03, 0.1));
  placer_.addSamples(MovingSensor::sample(1.03, 0.1));  // 1 s later: waiting is allowed as long
  EXPECT_EQ(droppedFor("no transform"), 0U);
  placer_.addSamples(MovingSensor::sample(1.04, 0.1));
  EXPECT_EQ(droppedFor("no transform"), 1U);
  EXPECT_EQ(placed(), 0U);  // the last reading, 10 ms old, is not used
  placer_.finish();
  EXPECT_EQ(droppedFor("no transform"), 3U);
  EXPECT_EQ(placer_.acknowledged(), MovingSensor::stamp(1.04));
  expectAllCounted();
}

TEST_F(SamplePlacerTest, DropsAcrossGapsAndJumps) {
  addMount();
  addReadings(0, 2);
  placer_.addTransform(MovingSensor::linkTransform(0.08), false);
  auto jumped = MovingSensor::linkTransform(0.09);
  jumped.transform.translation.z += 0.2;  // 20 m/s
  placer_.addTransform(jumped, false);
  placer_.addSamples(MovingSensor::samples(-0.01, {0.0, 0.025, 0.06, 0.09, 0.095}, {0.1, 0.1, 0.1, 0.1, 0.1}));
  EXPECT_EQ(droppedFor("no joint reading"), 1U);
  EXPECT_EQ(droppedFor("joint readings too far apart"), 1U);
  EXPECT_EQ(droppedFor("transform jumps"), 1U);
  EXPECT_EQ(placed(), 2U);
  expectPoint(0, 0.015, 0.1);
  expectPoint(1, 0.08, 0.1);  // on a reading, whatever lies beside it
  expectAllCounted();
}

// 2 mm within 10 ms is no more than a sensor's speed allows, but from then on everything is measured elsewhere.
TEST_F(SamplePlacerTest, FailsAScanOfARobotThatSlips) {
  for (const double slip : {0.0, 2e-3}) {
    placer_.restart(placer_.options());
    const double begin = slip > 0.0 ? 2.0 : 0.0;
    addMount();
    for (int i = 0; i < 100; ++i) {
      auto link = MovingSensor::linkTransform(begin + 0.01 * i);
      if (i >= 50) link.transform.translation.z += slip;
      placer_.addTransform(link, false);
      if (i > 0) placer_.addSamples(MovingSensor::sample(begin + 0.01 * i - 0.005, 0.1));
    }
    ASSERT_EQ(placed(), 99U);
    if (slip == 0.0) {
      EXPECT_NO_THROW(placer_.take());
    } else {
      expectInputError([&] { placer_.take(); }, "the sensor jumps by 2.000 mm along z of the base");
    }
  }
}

TEST_F(SamplePlacerTest, DropsRangesThatAreNone) {
  addMount();
  addReadings(0, 10);
  placer_.addSamples(MovingSensor::samples(0.02, {0.0, 0.001, 0.002, 0.003}, {nan, infinity, 0.1, -infinity}));
  EXPECT_EQ(droppedFor("sensor fault"), 1U);
  EXPECT_EQ(droppedFor("no return"), 2U);
  EXPECT_EQ(placed(), 1U);
  expectPoint(0, 0.022, 0.1);
  expectAllCounted();
}

// A driver need not know what a sensor says when it measures nothing: it rests at the end of its range.
TEST_F(SamplePlacerTest, TakesWhatLiesOutsideTheMeasuringRangeForNone) {
  startWithRange(0.05, 0.15);
  placer_.addSamples(MovingSensor::samples(0.02, {0.0, 0.001, 0.002, 0.003, 0.004}, {0.049, 0.05, nan, 0.15, 0.151}));
  EXPECT_EQ(droppedFor("no return"), 2U);
  EXPECT_EQ(droppedFor("sensor fault"), 1U);
  ASSERT_EQ(placed(), 2U);
  expectPoint(0, 0.021, 0.05);
  expectPoint(1, 0.023, 0.15);
  expectAllCounted();
  const auto stage = placer_.take();
  ASSERT_EQ(stage.no_returns.beams.size(), 3U);
  EXPECT_TRUE(stage.no_returns.beams[0].is_too_near);
  EXPECT_TRUE(stage.no_returns.beams[1].is_too_near);  // for all that a fault says
  EXPECT_FALSE(stage.no_returns.beams[2].is_too_near);
}

TEST_F(SamplePlacerTest, RefusesMessagesThatNoSensorSends) {
  addMount();
  addReadings(0, 10);
  auto foreign = MovingSensor::sample(0.02, 0.1);
  foreign.header.frame_id = "camera";
  expectInputError([&] { placer_.addSamples(foreign); }, "frame_id is 'camera', must be 'sensor'");
  expectInputError(
      [&] {
        placer_.addSamples(MovingSensor::samples(0.02, {0.0}, {0.1, 0.1}));
      },
      "1 time offsets and 2 ranges");
  expectInputError([&] { placer_.addSamples(MovingSensor::samples(0.02, {0.0, 0.0}, {0.1, 0.1})); }, "time_offset[1]");
  expectInputError(
      [&] {
        placer_.addSamples(MovingSensor::samples(0.02, {0.0, nan}, {0.1, 0.1}));
      },
      "time_offset[1] is nan");
  expectInputError([&] { placer_.addSamples(MovingSensor::samples(0.02, {-0.1}, {0.1})); }, "time_offset[0] is -0.1");
  EXPECT_EQ(droppedFor("refused"), 8U);
  EXPECT_EQ(placed(), 0U);
  placer_.addSamples(MovingSensor::sample(0.05, 0.1));
  expectInputError([&] { placer_.addSamples(MovingSensor::sample(0.05, 0.1)); },
                   "is not after the last sample's 100.050000 s");
  EXPECT_EQ(placed(), 1U);
  EXPECT_EQ(droppedFor("refused"), 9U);
  placer_.addSamples(MovingSensor::samples(0.06, {}, {}));  // nothing is no error
  expectAllCounted();
}

TEST_F(SamplePlacerTest, AddsTheClockOffsetToTheSensorsStamps) {
  SamplePlacerOptions options;
  options.clock_offset = 0.013;
  placer_.restart(options);
  addMount();
  addReadings(0, 10);
  placer_.addSamples(MovingSensor::sample(0.02, 0.1));
  ASSERT_EQ(placed(), 1U);
  expectPoint(0, 0.033, 0.1);
}

TEST_F(SamplePlacerTest, FailsAScanWhoseClockWentBackAndTakesTheNext) {
  addMount();
  addReadings(0, 10);
  placer_.addSamples(MovingSensor::samples(0.05, {0.0, 0.06}, {0.1, 0.1}));
  addReadings(-500, -490);  // 5 s back
  EXPECT_EQ(droppedFor("clock went back"), 1U);
  EXPECT_EQ(placer_.waiting(), 0U);
  expectAllCounted();
  expectInputError([&] { placer_.take(); }, "clock of the transforms went back by 5.100 s");
  placer_.restart(SamplePlacerOptions());
  placer_.addSamples(MovingSensor::sample(-4.95, 0.1));
  ASSERT_EQ(placed(), 1U);
  expectPoint(0, -4.95, 0.1);
  EXPECT_NO_THROW(placer_.take());
}

TEST_F(SamplePlacerTest, HandsOnCloudBeamAndCounts) {
  addMount();
  addReadings(0, 10);
  placer_.addSamples(MovingSensor::samples(0.02, {0.0, 0.001, 0.002}, {0.1, infinity, 0.1}));
  const auto stage = placer_.take();
  EXPECT_EQ(stage.report.in, 3U);
  EXPECT_EQ(stage.report.out, 2U);
  EXPECT_EQ(stage.cloud->size(), 2U);
  EXPECT_EQ(stage.cloud->width, 2U);
  EXPECT_EQ(stage.cloud->header.frame_id, "base_link");
  EXPECT_EQ(stage.cloud->header.stamp, 100020000U);                                     // [us]
  EXPECT_LT((stage.mean_beam - core::geometry::Vector3(0.0, 0.0, -1.0)).norm(), 1e-9);  // roundedDirection's digits
  EXPECT_EQ(placer_.samplesIn(), 0U);
  EXPECT_TRUE(placer_.acknowledged().isZero());
}

TEST_F(SamplePlacerTest, KeepsWhereBeamsWithoutAReturnEnd) {
  startWithRange(0.05, 0.15);
  placer_.addSamples(MovingSensor::samples(0.02, {0.0, 0.001, 0.002, 0.1}, {infinity, 0.1, -infinity, infinity}));
  placer_.finish();
  const auto stage = placer_.take();
  EXPECT_NEAR(stage.no_returns.range, 0.1, 1e-12);
  ASSERT_EQ(stage.no_returns.beams.size(), 2U);  // of the last one no reading tells where it went
  EXPECT_LT((stage.no_returns.beams[0].far_end.cast<double>() - MovingSensor::pointAt(0.02, 0.15)).norm(), rounding);
  EXPECT_FALSE(stage.no_returns.beams[0].is_too_near);
  EXPECT_LT((stage.no_returns.beams[1].far_end.cast<double>() - MovingSensor::pointAt(0.022, 0.15)).norm(), rounding);
  EXPECT_TRUE(stage.no_returns.beams[1].is_too_near);
  ASSERT_EQ(stage.report.dropped.size(), 1U);
  EXPECT_EQ(stage.report.dropped[0].reason, "no return");
  EXPECT_EQ(stage.report.dropped[0].count, 3U);
}

TEST_F(SamplePlacerTest, SaysWhyNothingCouldBePlaced) {
  placer_.addSamples(MovingSensor::samples(0.02, {0.0, 0.001}, {nan, 0.1}));
  placer_.finish();
  expectInputError([&] { placer_.take(); }, "none of 2 samples could be placed, 1 sensor fault, 1 no transform");
}

}  // namespace
}  // namespace scan_to_path_ros
