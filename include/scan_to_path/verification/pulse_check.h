// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scan_to_path/motion/motion_plan.h"
#include "scan_to_path/robot/encoders.h"

namespace scan_to_path::verification {

/// What a pulse file says that the trajectory does not.
struct PulseCheck {
  std::size_t points = 0;           ///< read
  std::size_t mismatches = 0;       ///< points missing or too many, times off by more than 1 us, other waypoints
  std::string first_mismatch;       ///< the first of them in words; empty without
  double largest_difference = 0.0;  ///< of any joint [counts]
};

/// Reads the text of a pulse file and compares it with the trajectory it was made from, point by point. The pulses are
/// read and turned into joint angles by the settings themselves, sharing no code with robot::Encoders and the writer:
/// each motor's angle is sign 2 pi pulses / (counts_per_turn gear_ratio), the controller's axes are the coupling times
/// these, a joint is its axis (the coupled one: less the other joints of its sum) plus its offset. Differences of
/// angles are given in counts. A text that is no pulse file counts as one mismatch. The settings are those of a valid
/// robot::Encoders of this robot.
PulseCheck checkPulses(const std::string& text, const motion::Trajectory& trajectory,
                       const robot::EncoderOptions& options, const robot::Robot& robot);

}  // namespace scan_to_path::verification
