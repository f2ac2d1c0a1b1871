// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/point_laser.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {

namespace {

/// The voltages between which the sensor measures, the one of the near end first.
std::pair<double, double> measuringVoltages(const PointLaserOptions& laser) {
  const double inwards = std::copysign(laser.voltage_margin, laser.voltage_max - laser.voltage_min);
  return {laser.voltage_min + inwards, laser.voltage_max - inwards};
}

double distanceOnLine(const PointLaserOptions& laser, double voltage) {
  const double share = (voltage - laser.voltage_min) / (laser.voltage_max - laser.voltage_min);
  return laser.distance_min + share * (laser.distance_max - laser.distance_min);
}

}  // namespace

MeasuringRange measuringRange(const PointLaserOptions& laser) {
  const auto [near, far] = measuringVoltages(laser);
  return {distanceOnLine(laser, near), distanceOnLine(laser, far)};
}

std::optional<double> distanceFromVoltage(const PointLaserOptions& laser, double voltage) {
  const auto [near, far] = measuringVoltages(laser);
  const auto [low, high] = std::minmax(near, far);
  if (!(voltage >= low && voltage <= high)) return std::nullopt;  // NaN too
  return distanceOnLine(laser, voltage);
}

bool isTooNear(const PointLaserOptions& laser, double voltage) {
  const double near = measuringVoltages(laser).first;
  const bool is_rising = laser.voltage_max > laser.voltage_min;
  return is_rising ? voltage < near : voltage > near;
}

double voltageFromDistance(const PointLaserOptions& laser, double distance) {
  const double share = (distance - laser.distance_min) / (laser.distance_max - laser.distance_min);
  return laser.voltage_min + share * (laser.voltage_max - laser.voltage_min);
}

void validateLaser(const PointLaserOptions& laser) {
  validate(laser, "laser");
  if (!(laser.distance_max > laser.distance_min)) {
    throw InputError("laser", "distance_max", fixed(laser.distance_max, 6) + " m",
                     "above distance_min, " + fixed(laser.distance_min, 6) + " m");
  }
  if (laser.voltage_max == laser.voltage_min) {
    throw InputError("laser", "voltage_max", fixed(laser.voltage_max, 6) + " V", "different from voltage_min");
  }
  const double half = 0.5 * std::abs(laser.voltage_max - laser.voltage_min);
  if (!(laser.voltage_margin < half)) {
    throw InputError("laser", "voltage_margin", fixed(laser.voltage_margin, 6) + " V",
                     "below half of the output's range, " + fixed(half, 6) + " V");
  }
}

}  // namespace scan_to_path::sensing
