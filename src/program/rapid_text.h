// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scan_to_path/program/axis_configuration.h"
#include "scan_to_path/program/program.h"

namespace scan_to_path::program {

/// RAPID data written as text: lengths in mm, angles in degrees, quaternions as w, x, y, z. RAPID's num is a 32-bit
/// float: 1e-4 mm and 1e-8 in a quaternion are its resolution at the size of a robot. Throw InputError for a number
/// that is not finite.
std::string rapidNumber(double value, int digits);
std::string rapidPosition(const geometry::Vector3& position);
std::string rapidOrientation(const Eigen::Matrix3d& R);
std::string rapidAxes(const JointVector& axes);
std::string rapidConfiguration(const AxisConfiguration& configuration);

/// Comment lines of at most 80 columns that hold `text`, wrapped at blanks.
void appendComment(std::string& module, std::string_view text);

/// The header of the main module: what it is, the safety notice, where it comes from, units.
void appendHeader(std::string& module, const ProgramInput& input, std::size_t moves);

}  // namespace scan_to_path::program
