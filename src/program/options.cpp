// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/options.h"

#include <cctype>
#include <set>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/program/rapid_names.h"

namespace scan_to_path::program {
namespace {

void checkVector(const char* name, const char* unit, const Vector3& value, double min, double max) {
  for (int i = 0; i < 3; ++i) {
    if (!(value[i] >= min && value[i] <= max)) {
      throw InputError(std::string("program.") + name + "[" + std::to_string(i) + "] is " + std::to_string(value[i]) +
                       " " + unit + ", must be in [" + fixed(min, 1) + ", " + fixed(max, 1) + "]");
    }
  }
}

/// The program's own names begin like these; a user's name must not.
bool isOwnName(const std::string& lower) {
  static const std::set<std::string> own = {"checkrobot", "start_axes", "start_pose", "dry_run",
                                            "scantopath", "here",       "turn"};
  for (const char* prefix : {"part_", "feed_", "zone_", "scantopath_"}) {
    if (lower.rfind(prefix, 0) == 0) return true;
  }
  // Routines of segments: s<number>_…
  const bool segment = lower.size() > 1 && lower[0] == 's' && std::isdigit(static_cast<unsigned char>(lower[1])) != 0;
  return segment || own.count(lower) > 0;
}

void checkNames(const ProgramOptions& options) {
  std::set<std::string> seen;
  for (const auto& [key, name] :
       {std::pair{"tool_name", &options.tool_name}, std::pair{"workobject_name", &options.workobject_name},
        std::pair{"process_on", &options.process_on}, std::pair{"process_off", &options.process_off},
        std::pair{"process_signal", &options.process_signal}}) {
    if (name->empty() && name == &options.process_signal) continue;
    const std::string where = std::string("program.") + key;
    checkRapidName(where, *name);
    std::string lower = *name;
    for (auto& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (isOwnName(lower)) throw InputError(where, "name", "'" + *name + "'", "no name of the program's own");
    if (!seen.insert(lower).second) throw InputError(where, "name", "'" + *name + "'", "used only once");
  }
}

/// A lift that blends in the air could use up is no air run.
void checkDryOffset(const ProgramOptions& options) {
  const double least = 0.005 + options.air_tolerance;  // [m]
  if (options.dry_offset == 0.0 || options.dry_offset >= least) return;
  throw InputError("program.dry_offset is " + fixed(options.dry_offset, 6) + " m, must be 0 or at least " +
                   fixed(least, 4) + " m (5 mm over program.air_tolerance)");
}

}  // namespace

void validateProgramOptions(const ProgramOptions& options) {
  validate(options, "program");
  checkVector("tool_centre_of_gravity", "m", options.tool_centre_of_gravity, -5.0, 5.0);
  checkVector("tool_inertia", "kg m^2", options.tool_inertia, 0.0, 1e4);
  checkVector("dry_direction", "", options.dry_direction, -1e3, 1e3);
  if (options.dry_direction.norm() < 1e-3) {
    throw InputError("program.dry_direction has length " + fixed(options.dry_direction.norm(), 6) +
                     ", must be a direction");
  }
  checkDryOffset(options);
  checkNames(options);
}

}  // namespace scan_to_path::program
