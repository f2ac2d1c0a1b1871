// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/pulse_check.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/motion/trajectory.h"

namespace scan_to_path::verification {
namespace {

using motion::Trajectory;
using motion::TrajectoryPoint;

constexpr double time_limit = 1e-6;  // [s]; written to 1e-6, so half of it is rounding

/// The difference of two points in words; empty when they are the same but for their angles.
std::string mismatchOf(const TrajectoryPoint& read, const TrajectoryPoint& planned) {
  if (read.segment != planned.segment || read.index != planned.index) return "names another waypoint";
  return std::abs(read.time - planned.time) <= time_limit ? "" : "is at another time";
}

void addMismatch(PulseCheck& check, const std::string& text) {
  if (check.mismatches++ == 0) check.first_mismatch = "pulses.csv " + text;
}

}  // namespace

PulseCheck checkPulses(const std::string& text, const Trajectory& trajectory, const robot::Encoders& encoders) {
  PulseCheck check;
  Trajectory read;
  try {
    read = motion::parsePulses(text, "pulses.csv", encoders);
  } catch (const InputError& error) {
    check.mismatches = 1;
    check.first_mismatch = error.what();
    return check;
  }
  check.points = read.points.size();
  if (read.joint_names != trajectory.joint_names) addMismatch(check, "names other joints");
  if (read.points.size() != trajectory.points.size()) {
    addMismatch(check, "has " + std::to_string(read.points.size()) + " points, the trajectory " +
                           std::to_string(trajectory.points.size()));
    return check;
  }
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    const TrajectoryPoint& planned = trajectory.points[i];
    const std::string mismatch = mismatchOf(read.points[i], planned);
    if (!mismatch.empty()) addMismatch(check, "point " + std::to_string(i) + " " + mismatch);
    const robot::JointVector off = encoders.counts(read.points[i].q) - encoders.counts(planned.q);
    check.largest_difference = std::max(check.largest_difference, off.cwiseAbs().maxCoeff());
  }
  return check;
}

}  // namespace scan_to_path::verification
