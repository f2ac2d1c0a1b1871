// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/options.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

TEST(ProgramOptions, DefaultsAreValid) { EXPECT_NO_THROW(validateProgramOptions({})); }

TEST(ProgramOptions, BadValuesAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, std::function<void(ProgramOptions&)>> cases[] = {
      {"program.tool_mass", [](auto& o) { o.tool_mass = 0.0; }},
      {"program.tool_mass", [nan](auto& o) { o.tool_mass = nan; }},
      {"program.tool_centre_of_gravity[1]", [nan](auto& o) { o.tool_centre_of_gravity.y() = nan; }},
      {"program.tool_inertia[2]", [](auto& o) { o.tool_inertia.z() = -1.0; }},
      {"program.dry_offset", [](auto& o) { o.dry_offset = -0.1; }},
      {"program.dry_offset is 0.000001 m, must be 0 or at least 0.0055 m", [](auto& o) { o.dry_offset = 1e-6; }},
      {"program.dry_direction", [](auto& o) { o.dry_direction.setZero(); }},
      {"program.start_speed", [](auto& o) { o.start_speed = 1.0; }},
      {"program.moves_per_routine", [](auto& o) { o.moves_per_routine = 0; }},
      {"program.tool_name", [](auto& o) { o.tool_name = "tool0"; }},
      {"program.workobject_name", [](auto& o) { o.workobject_name = "a b"; }},
      {"program.process_on", [](auto& o) { o.process_on = ""; }},
      {"program.process_off", [](auto& o) { o.process_off = "processon"; }},  // case does not tell names apart
      {"program.process_signal", [](auto& o) { o.process_signal = "1do"; }},
      {"program.tool_name", [](auto& o) { o.tool_name = "Feed_3"; }},
      {"program.tool_name", [](auto& o) { o.tool_name = "S3_row"; }},
      {"program.process_on", [](auto& o) { o.process_on = "CheckRobot"; }},
  };
  for (const auto& [text, spoil] : cases) {
    ProgramOptions options;
    spoil(options);
    test::expectInputError([&o = options] { validateProgramOptions(o); }, text);
  }
}

}  // namespace
}  // namespace scan_to_path::program
