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

/// Reads the text of a pulse file and compares it with the trajectory it was made from, point by point. Angles are
/// compared through Encoders::angles, which is not what the writer counts with; their difference is given in counts.
/// A text that is no pulse file counts as one mismatch.
PulseCheck checkPulses(const std::string& text, const motion::Trajectory& trajectory, const robot::Encoders& encoders);

}  // namespace scan_to_path::verification
