// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/point_laser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::sensing {
namespace {

TEST(PointLaser, DefaultsAreTheSeedsSensor) {
  PointLaserOptions laser;
  EXPECT_DOUBLE_EQ(distanceFromVoltage(laser, -4.97).value(), 0.05515);
  EXPECT_DOUBLE_EQ(distanceFromVoltage(laser, 0.0).value(), 0.080);
  EXPECT_DOUBLE_EQ(distanceFromVoltage(laser, 4.97).value(), 0.10485);
  laser.voltage_margin = 0.0;
  EXPECT_DOUBLE_EQ(distanceFromVoltage(laser, -5.0).value(), 0.055);
  EXPECT_DOUBLE_EQ(distanceFromVoltage(laser, 5.0).value(), 0.105);
}

TEST(PointLaser, VoltageAndBackIsTheSameDistance) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    PointLaserOptions laser;
    laser.voltage_max = i % 2 == 0 ? 10.0 : -10.0;  // output falling with distance
    laser.voltage_min = 0.5;
    const MeasuringRange range = measuringRange(laser);
    const double distance = random.uniform(range.nearest, range.farthest);
    EXPECT_NEAR(distanceFromVoltage(laser, voltageFromDistance(laser, distance)).value(), distance, 1e-15);
  }
}

// Whichever way the voltage runs: what is no distance at the near end is too near, and nothing else is.
TEST(PointLaser, TooNearIsBeyondTheNearEndsMargin) {
  PointLaserOptions laser;
  for (const double sign : {1.0, -1.0}) {
    laser.voltage_min = -5.0 * sign;
    laser.voltage_max = 5.0 * sign;
    for (const double share : {-10.0, -5.1, -5.0, -4.998, -4.9701, -4.97, -4.9, 0.0, 4.9, 4.97, 4.9701, 5.0, 9.9}) {
      const bool is_measured = std::abs(share) <= 4.97;
      EXPECT_EQ(distanceFromVoltage(laser, share * sign).has_value(), is_measured) << share * sign;
      EXPECT_EQ(isTooNear(laser, share * sign), !is_measured && share < 0.0) << share * sign;
    }
  }
  EXPECT_FALSE(isTooNear(laser, std::numeric_limits<double>::quiet_NaN()));
}

// A sensor that measures nothing rests at the end of its output; converter and noise show it as this far off at most.
TEST(PointLaser, NothingAtTheEndsOfTheOutput) {
  const PointLaserOptions laser;
  for (const double end : {-5.0, 5.0}) {
    for (const double error : {-0.029, -3e-4, 0.0, 3e-4, 0.029}) {
      EXPECT_FALSE(distanceFromVoltage(laser, end + error)) << end + error;
      EXPECT_EQ(isTooNear(laser, end + error), end < 0.0);
    }
  }
  EXPECT_FALSE(distanceFromVoltage(laser, std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(distanceFromVoltage(laser, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(distanceFromVoltage(laser, voltageFromDistance(laser, 0.1051)));
}

TEST(PointLaser, TheMeasuringRangeEndsWhereDistancesDo) {
  PointLaserOptions laser;
  for (const double margin : {0.0, 0.03, 0.7}) {
    laser.voltage_margin = margin;
    const MeasuringRange range = measuringRange(laser);
    EXPECT_EQ(distanceFromVoltage(laser, -5.0 + margin).value(), range.nearest);
    EXPECT_EQ(distanceFromVoltage(laser, 5.0 - margin).value(), range.farthest);
    EXPECT_FALSE(distanceFromVoltage(laser, std::nextafter(-5.0 + margin, -6.0)));
    EXPECT_FALSE(distanceFromVoltage(laser, std::nextafter(5.0 - margin, 6.0)));
  }
}

TEST(PointLaser, BadRangesAreNamed) {
  PointLaserOptions laser;
  laser.distance_max = laser.distance_min;
  test::expectInputError([&] { validateLaser(laser); }, "laser: distance_max is 0.055000 m, must be above");
  laser = {};
  laser.voltage_max = laser.voltage_min;
  test::expectInputError([&] { validateLaser(laser); }, "voltage_max is -5.000000 V, must be different");
  laser = {};
  laser.voltage_min = std::numeric_limits<double>::quiet_NaN();
  test::expectInputError([&] { validateLaser(laser); }, "laser.voltage_min is nan");
  laser = {};
  laser.voltage_margin = 5.0;
  test::expectInputError([&] { validateLaser(laser); }, "voltage_margin is 5.000000 V, must be below half");
}

}  // namespace
}  // namespace scan_to_path::sensing
