// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scan_to_path/motion/motion_plan.h"
#include "scan_to_path/robot/encoders.h"

namespace scan_to_path::motion {

/// trajectory.csv: `t,segment,index,<joint names…>` in s (1e-6) and rad (1e-9).
std::string formatTrajectory(const Trajectory& trajectory);

/// pulses.csv: the same with encoder counts, rounded to integers, for position-controlled controllers.
std::string formatPulses(const Trajectory& trajectory, const robot::Encoders& encoders);

/// The inverse of formatTrajectory. Throws InputError with the line number: a header of another form, a cell that is
/// no finite number, a segment or index that is no whole number, times that do not rise.
Trajectory parseTrajectory(const std::string& text, const std::string& name);

/// The inverse of formatPulses, counts turned into angles. Throws InputError as parseTrajectory.
Trajectory parsePulses(const std::string& text, const std::string& name, const robot::Encoders& encoders);

}  // namespace scan_to_path::motion
