// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scan_to_path/common/options.h"
#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::pipeline {

/// What an input file holds.
enum class InputKind { samples, cloud, mesh, cad };

/// Length unit of a file that does not carry its own.
enum class Units { m, mm, inch };

double metresPerUnit(Units units);

/// Decides by content, not by name. Throws InputError, saying what the file looks like, for anything else.
InputKind detectInput(std::string_view content, const std::string& name);

/// A file without a unit whose part comes out smaller than 5 mm or larger than 20 m was read in the wrong unit.
/// Throws InputError with the suggestion of a unit that fits, to be said with `flag`. `bounds` in metres as read with
/// `units`.
void checkPlausibleSize(const Eigen::AlignedBox3d& bounds, Units units, const std::string& name,
                        const std::string& flag = "--units");

}  // namespace scan_to_path::pipeline

namespace scan_to_path {
template <>
struct EnumNames<pipeline::InputKind> {
  static constexpr std::array<const char*, 4> names = {"samples", "cloud", "mesh", "cad"};
};
template <>
struct EnumNames<pipeline::Units> {
  static constexpr std::array<const char*, 3> names = {"m", "mm", "inch"};
};
}  // namespace scan_to_path
