// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scan_to_path/common/options.h"

namespace scan_to_path::sensing {

/// A triangulation displacement sensor with an analogue output, linear between the two ends of its range. It looks
/// along +z of its own frame. Defaults: the seed's IL-065 behind a +-10 V converter, whose data sheet (EL3104) allows
/// an error of 0.3 % of its full scale, 30 mV: a sensor that rests at the end of its output is read as within that of
/// it.
struct PointLaserOptions {
  double distance_min = 0.055;
  double distance_max = 0.105;
  double voltage_min = -5.0;
  double voltage_max = 5.0;
  double voltage_margin = 0.03;
  int max_repeats = 50;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.distance_min, Field{"distance_min", "m", "distance at voltage_min", 0.0, 100.0});
    visit(self.distance_max, Field{"distance_max", "m", "distance at voltage_max", 0.0, 100.0});
    visit(self.voltage_min, Field{"voltage_min", "V", "output at distance_min", -100.0, 100.0});
    visit(self.voltage_max,
          Field{"voltage_max", "V", "output at distance_max; outside the two: no return", -100.0, 100.0});
    visit(self.voltage_margin,
          Field{"voltage_margin", "V",
                "nearer than this to either end the sensor rests at it: no return; noise and converter's error", 0.0,
                10.0});
    visit(self.max_repeats, Field{"max_repeats", "",
                                  "more equal voltages on end in a log with noise are a sensor that rests: refused; 0: "
                                  "none are",
                                  0, 1e9});
  }
};

/// What is measured: the range without what lies within voltage_margin of its ends [m].
struct MeasuringRange {
  double nearest = 0.0;
  double farthest = 0.0;
};

MeasuringRange measuringRange(const PointLaserOptions& laser);

/// Distance [m] for a voltage; nothing outside the measuring range (no return) and for NaN (fault): a sensor whose
/// output ends at voltage_min and voltage_max rests there when it measures nothing. Spec cutting, step 1.
std::optional<double> distanceFromVoltage(const PointLaserOptions& laser, double voltage);

/// True for a voltage beyond the measuring range's near end: something is there, too near. Beyond the other end it may
/// be too far or nothing at all.
bool isTooNear(const PointLaserOptions& laser, double voltage);

/// Voltage for a distance, not limited to the range.
double voltageFromDistance(const PointLaserOptions& laser, double distance);

/// Throws InputError when the ends of the range coincide, or the margins leave nothing between them.
void validateLaser(const PointLaserOptions& laser);

}  // namespace scan_to_path::sensing
