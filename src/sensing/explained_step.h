// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace scan_to_path::sensing {

/// Up to three readings of one joint, counted outward from the interval between two readings.
struct SideReadings {
  int count = 0;
  double time[3] = {};   ///< [s]
  double angle[3] = {};  ///< [rad]

  /// Leaves out what is not at least `spacing` [s] from the last one.
  void addFarther(double t, double q, double spacing) {
    if (count > 0 && std::abs(t - time[count - 1]) < spacing) return;
    time[count] = t;
    angle[count++] = q;
  }
};

/// The steps over an interval that the motion on both sides of it explains.
struct ExplainedStep {
  double low = 0.0;    ///< [rad]
  double high = 0.0;   ///< [rad]
  double speed = 0.0;  ///< the larger of the two at the interval's ends [rad/s]

  double width() const { return high - low; }

  /// How far a step lies outside [rad].
  double excess(double step) const {
    if (step > high) return step - high;
    return step < low ? low - step : 0.0;
  }
};

/// Of a joint at the reading next to the interval, along rising time: from the parabola through the readings.
struct EndMotion {
  double mean_speed = 0.0;    ///< of the two nearest readings [rad/s]
  double speed = 0.0;         ///< [rad/s]
  double acceleration = 0.0;  ///< [rad/s^2]
};

EndMotion endMotion(const SideReadings& side);

/// Nothing but the readings before and after an interval is asked: the parabola through three of them tells speed and
/// acceleration at the interval's end. Explained is all between the steps of the mean speed of the nearest readings, of
/// the speed at the end, and of the parabola carried on, for both sides: the joint may change from one motion to the
/// other anywhere in the interval, or have its fastest moment within it. With one side only it may have started or
/// stopped there; with none anything is.
ExplainedStep explainedStep(const SideReadings& before, const SideReadings& after);

/// True when the joint comes to rest next to the interval, or leaves it: it would stand still one and a half readings
/// on, or does already, within `resolution` [rad] from reading to reading. A reading alone shows no rest.
bool isRestingNextTo(const SideReadings& side, double resolution);

}  // namespace scan_to_path::sensing
