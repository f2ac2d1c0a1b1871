// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/point_laser.h"

#include <algorithm>
#include <string>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {

std::optional<double> distanceFromVoltage(const PointLaserOptions& laser, double voltage) {
  const auto [low, high] = std::minmax(laser.voltage_min, laser.voltage_max);
  if (!(voltage >= low && voltage <= high)) return std::nullopt;  // NaN too
  const double share = (voltage - laser.voltage_min) / (laser.voltage_max - laser.voltage_min);
  return laser.distance_min + share * (laser.distance_max - laser.distance_min);
}

bool isTooNear(const PointLaserOptions& laser, double voltage) {
  const bool is_rising = laser.voltage_max > laser.voltage_min;
  return is_rising ? voltage < laser.voltage_min : voltage > laser.voltage_min;
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
}

}  // namespace scan_to_path::sensing
