// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/point_laser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::sensing {
namespace {

TEST(PointLaser, DefaultsAreTheSeedsSensor) {
  const PointLaserOptions laser;
  EXPECT_DOUBLE_EQ(distanceFromVoltage(laser, -5.0).value(), 0.055);
  EXPECT_DOUBLE_EQ(distanceFromVoltage(laser, 0.0).value(), 0.080);
  EXPECT_DOUBLE_EQ(distanceFromVoltage(laser, 5.0).value(), 0.105);
}

TEST(PointLaser, VoltageAndBackIsTheSameDistance) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    PointLaserOptions laser;
    laser.voltage_max = i % 2 == 0 ? 10.0 : -10.0;  // output falling with distance
    laser.voltage_min = 0.5;
    const double distance = random.uniform(laser.distance_min, laser.distance_max);
    EXPECT_NEAR(distanceFromVoltage(laser, voltageFromDistance(laser, distance)).value(), distance, 1e-15);
  }
}

// Whichever way the voltage runs.
TEST(PointLaser, TooNearIsBeyondTheNearEnd) {
  PointLaserOptions laser;
  EXPECT_TRUE(isTooNear(laser, -5.1));
  EXPECT_FALSE(isTooNear(laser, -5.0));
  EXPECT_FALSE(isTooNear(laser, 5.1));
  EXPECT_FALSE(isTooNear(laser, std::numeric_limits<double>::quiet_NaN()));
  std::swap(laser.voltage_min, laser.voltage_max);
  EXPECT_TRUE(isTooNear(laser, 5.1));
  EXPECT_FALSE(isTooNear(laser, -5.1));
}

TEST(PointLaser, NothingOutsideTheRange) {
  const PointLaserOptions laser;
  EXPECT_FALSE(distanceFromVoltage(laser, std::nextafter(-5.0, -6.0)));
  EXPECT_FALSE(distanceFromVoltage(laser, std::nextafter(5.0, 6.0)));
  EXPECT_FALSE(distanceFromVoltage(laser, std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(distanceFromVoltage(laser, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(distanceFromVoltage(laser, voltageFromDistance(laser, 0.1051)));
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
}

}  // namespace
}  // namespace scan_to_path::sensing
