// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::program {

using geometry::Vector3;

/// What a robot program says beyond the path and the joint angles.
struct ProgramOptions {
  std::string tool_name = "tool_scan";
  std::string workobject_name = "wobj_scan";
  double tool_mass = 5.0;
  Vector3 tool_centre_of_gravity = Vector3(0.0, 0.0, 0.1);
  Vector3 tool_inertia = Vector3::Zero();
  double dry_offset = 0.0;
  Vector3 dry_direction = Vector3::UnitZ();
  double zone_tolerance = 10e-6;
  double air_tolerance = 0.5e-3;
  double zone_orientation = 0.0175;
  double start_speed = 0.1;
  double max_speed = 1.0;
  double orientation_speed = 3.5;
  bool monitor_configuration = false;
  std::string process_on = "ProcessOn";
  std::string process_off = "ProcessOff";
  std::string process_signal;
  double process_delay = 1.0;
  int moves_per_routine = 250;
  int moves_per_module = 1000;
  std::vector<std::string> comments;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.tool_name, Field{"tool_name", "", "name of the tool data in the program"});
    visit(self.workobject_name, Field{"workobject_name", "", "name of the work object in the program"});
    visit(self.tool_mass, Field{"tool_mass", "kg", "mass of everything on the flange", 1e-3, 1e4});
    visit(self.tool_centre_of_gravity,
          Field{"tool_centre_of_gravity", "m", "centre of gravity of the load, in the flange frame", -5.0, 5.0});
    visit(self.tool_inertia,
          Field{"tool_inertia", "kg m^2", "moments of inertia about the centre of gravity; 0: point mass", 0.0, 1e4});
    visit(
        self.dry_offset,
        Field{"dry_offset", "m",
              "air run: shift of the whole path, process off, 5 mm over air_tolerance or more; 0: real run", 0.0, 2.0});
    visit(self.dry_direction, Field{"dry_direction", "", "direction of dry_offset in the work object's frame"});
    visit(self.zone_tolerance, Field{"zone_tolerance", "m",
                                     "how far blending may leave the lines between waypoints, process on", 0.0, 0.01});
    visit(self.air_tolerance, Field{"air_tolerance", "m", "the same between moves with the process off", 0.0, 0.1});
    visit(self.zone_orientation, Field{"zone_orientation", "rad", "largest turn inside a zone", 0.0, 1.0});
    visit(self.start_speed, Field{"start_speed", "m/s", "speed of the move to the first waypoint", 1e-3, 0.25});
    visit(self.max_speed, Field{"max_speed", "m/s", "a faster feed is refused", 1e-3, 7.0});
    visit(self.orientation_speed, Field{"orientation_speed", "rad/s", "limit of the tool's turning", 1e-3, 17.5});
    visit(self.monitor_configuration,
          Field{"monitor_configuration", "", "stop where the arm's configuration is not the planned one (ConfL\\On)"});
    visit(self.process_on, Field{"process_on", "", "routine that starts the process"});
    visit(self.process_off, Field{"process_off", "", "routine that stops the process"});
    visit(self.process_signal, Field{"process_signal", "", "digital output set by those routines; empty: none"});
    visit(self.process_delay,
          Field{"process_delay", "s", "wait at a stop after process_signal is set, for a spindle to reach its speed",
                0.0, 600.0});
    visit(self.moves_per_routine, Field{"moves_per_routine", "", "moves in one routine", 1, 5000});
    visit(self.moves_per_module, Field{"moves_per_module", "", "moves in one module file", 1, 50000});
    visit(self.comments, Field{"comments", "", "lines added to the program's header"});
  }
};

/// Throws InputError for a number out of range, a name that the controller would not take (letters, digits and
/// underscore, at most 32, no reserved word), two equal names, or a direction of length 0.
void validateProgramOptions(const ProgramOptions& options);

}  // namespace scan_to_path::program
