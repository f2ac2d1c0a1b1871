// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/sensor_track.h"

#include <gtest/gtest.h>

#include "moving_sensor.h"
#include "support/expect_input_error.h"

namespace scan_to_path_ros {
namespace {

using test::MovingSensor;

constexpr double max_joint_jump = 5e-5;  // [rad], the default
constexpr double max_gap = 0.05;         // [s]

/// 2 s at 100 readings a second; `off` [m] is added to z from reading 80 to `last`.
SensorTrack track(double off = 0.0, int last = 1000) {
  SensorTrack track;
  for (int i = 0; i < 200; ++i) {
    auto T_base_sensor = MovingSensor::linkAt(0.01 * i) * MovingSensor::mount();
    if (i >= 80 && i <= last) T_base_sensor.translation().z() += off;
    track.add(placeOf(MovingSensor::stamp(0.01 * i), T_base_sensor), 2.0);
  }
  return track;
}

TEST(SensorTrack, OfEvenMotionHasNoJumps) {
  const auto unseen = checkSensorJumps(track(), max_joint_jump, max_gap);
  EXPECT_EQ(unseen.pauses, 0U);
  EXPECT_LT(unseen.distance, 1e-4);
}

// A turn of 50 urad about the base moves a sensor about 0.84 m from it by 42 um; it does not move along z.
TEST(SensorTrack, RefusesWhatMotionDoesNotExplain) {
  EXPECT_NO_THROW(checkSensorJumps(track(4e-5), max_joint_jump, max_gap));
  for (const double off : {6e-5, -6e-5, 1e-3}) {
    const std::string where = " mm along z of the base at 0.800 s";
    scan_to_path::test::expectInputError([&] { checkSensorJumps(track(off), max_joint_jump, max_gap); }, where);
    scan_to_path::test::expectInputError([&] { checkSensorJumps(track(off, 80), max_joint_jump, max_gap); }, where);
  }
  EXPECT_NO_THROW(checkSensorJumps(track(1e-3), 0.0, max_gap)) << "none is looked for";
}

TEST(SensorTrack, LeavesOutWhatNoRobotReaches) {
  SensorTrack track;
  track.add(placeOf(MovingSensor::stamp(0.0), MovingSensor::linkAt(0.0)), 2.0);
  auto wrong = MovingSensor::linkAt(0.01);
  wrong.translation().x() += 0.021;
  track.add(placeOf(MovingSensor::stamp(0.01), wrong), 2.0);
  EXPECT_EQ(track.size(), 1U);
  track.add(placeOf(MovingSensor::stamp(0.02), MovingSensor::linkAt(0.02)), 2.0);
  EXPECT_EQ(track.size(), 2U);
  EXPECT_EQ(track.end(), MovingSensor::stamp(0.02));
  track.clear();
  EXPECT_NO_THROW(checkSensorJumps(track, max_joint_jump, max_gap));
}

}  // namespace
}  // namespace scan_to_path_ros
