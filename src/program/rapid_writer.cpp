// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/rapid_writer.h"

#include <cmath>
#include <map>

#include "planned_moves.h"
#include "rapid_text.h"
#include "scan_to_path/common/angles.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/program/axis_configuration.h"
#include "scan_to_path/program/rapid_names.h"

namespace scan_to_path::program {
namespace {

constexpr const char* no_external_axes = "[9E9,9E9,9E9,9E9,9E9,9E9]";

/// Names of speed data, in order of first use.
class SpeedTable {
public:
  explicit SpeedTable(const std::vector<PlannedMove>& moves) {
    for (const auto& move : moves) {
      const std::string speed = rapidNumber(1e3 * move.feed, 3);
      if (names_.emplace(speed, "feed_" + std::to_string(names_.size() + 1)).second) order_.push_back(speed);
    }
  }

  const std::string& name(double feed) const { return names_.at(rapidNumber(1e3 * feed, 3)); }

  void appendData(std::string& module, double orientation_speed) const {
    const std::string turning = rapidNumber(degrees_per_radian * orientation_speed, 3);
    for (const auto& speed : order_) {
      module += "  CONST speeddata " + names_.at(speed) + " := [" + speed + "," + turning + ",5000,1000];\n";
    }
  }

private:
  std::map<std::string, std::string> names_;
  std::vector<std::string> order_;
};

std::string zoneName(double zone) {
  return zone > 0.0 ? "zone_" + std::to_string(std::lround(1e6 * zone)) + "um" : "fine";
}

void appendZones(std::string& module, const std::vector<PlannedMove>& moves, double zone_orientation) {
  std::map<double, bool> zones;
  for (const auto& move : moves) zones[move.zone] = true;
  zones.erase(0.0);
  const std::string turn = rapidNumber(degrees_per_radian * zone_orientation, 3);
  for (const auto& [zone, used] : zones) {
    const std::string radius = rapidNumber(1e3 * zone, 3);
    module += "  CONST zonedata " + zoneName(zone) + " := [FALSE," + radius + "," + radius + "," + radius + "," + turn +
              "," + radius + "," + turn + "];\n";
  }
}

std::string poseOnTwoLines(const Frame& T) {
  return "[" + rapidPosition(T.translation()) + ",\n    " + rapidOrientation(T.linear()) + "]";
}

void appendTool(std::string& module, const ProgramInput& input) {
  const auto& options = input.options;
  const auto& inertia = options.tool_inertia;
  module += "  PERS tooldata " + options.tool_name + " := [TRUE,\n    " + poseOnTwoLines(input.T_tip_tcp) + ",\n    [" +
            rapidNumber(options.tool_mass, 3) + "," + rapidPosition(options.tool_centre_of_gravity) + ",[1,0,0,0]," +
            rapidNumber(inertia.x(), 6) + "," + rapidNumber(inertia.y(), 6) + "," + rapidNumber(inertia.z(), 6) +
            "]];\n";
}

void appendWorkobject(std::string& module, const ProgramInput& input) {
  module += "  PERS wobjdata " + input.options.workobject_name + " := [FALSE,TRUE,\"\",\n    " +
            poseOnTwoLines(input.T_base_workobject) + ",\n    [[0,0,0],[1,0,0,0]]];\n";
}

void appendData(std::string& module, const ProgramInput& input, const std::vector<PlannedMove>& moves,
                const SpeedTable& speeds) {
  appendTool(module, input);
  appendWorkobject(module, input);
  const JointVector axes = robot::controllerAxes(input.robot, moves.front().q);
  module += "  CONST jointtarget start_axes := [\n    " + rapidAxes(axes) + ",\n    " + no_external_axes + "];\n";
  module += "  CONST pose start_pose :=\n    " + poseOnTwoLines(moves.front().T_workobject_tcp) + ";\n";
  speeds.appendData(module, input.options.orientation_speed);
  appendZones(module, moves, input.options.zone_orientation);
  module += std::string("  CONST bool dry_run := ") + (input.options.dry_offset > 0.0 ? "TRUE" : "FALSE") + ";\n";
}

/// The controller's own kinematics of the start axes against the plan's: a wrong arm, axis 3 convention, tool or base
/// frame shows here, before anything moves.
void appendRobotCheck(std::string& module, const ProgramOptions& options) {
  module +=
      "\n  ! Stops before the first move when this arm is not the planned one.\n"
      "  PROC CheckRobot()\n"
      "    VAR robtarget here;\n"
      "    VAR num turn;\n"
      "    here := CalcRobT(start_axes," +
      options.tool_name + "\\WObj:=" + options.workobject_name +
      ");\n"
      "    ! Cosine of half the angle between both: 0.99999 is 0.5 degrees.\n"
      "    turn := here.rot.q1*start_pose.rot.q1+here.rot.q2*start_pose.rot.q2;\n"
      "    turn := turn+here.rot.q3*start_pose.rot.q3+here.rot.q4*start_pose.rot.q4;\n"
      "    IF Distance(here.trans,start_pose.trans) > 0.5\n"
      "      OR Abs(turn) < 0.99999 THEN\n"
      "      TPWrite \"ScanToPath: start axes do not give the start point.\";\n"
      "      TPWrite \"Wrong robot, axis 3 convention, tool or base frame.\";\n"
      "      EXIT;\n"
      "    ENDIF\n"
      "  ENDPROC\n";
}

void appendProcessRoutine(std::string& module, const ProgramOptions& options, bool on) {
  const std::string name = on ? options.process_on : options.process_off;
  module += "\n  PROC " + name + "()\n";
  module +=
      on ? "    ! Start the process here; in an air run (dry_run) leave it off.\n" : "    ! Stop the process here.\n";
  if (!options.process_signal.empty()) {
    const std::string set = "SetDO " + options.process_signal + "," + (on ? "1" : "0") + ";\n";
    module += on ? "    IF NOT dry_run THEN\n      " + set + "    ENDIF\n" : "    " + set;
    // The arm stands at a stop point here.
    if (on && options.process_delay > 0.0) module += "    WaitTime " + rapidNumber(options.process_delay, 3) + ";\n";
  }
  module += "  ENDPROC\n";
}

void appendMain(std::string& module, const ProgramInput& input, std::size_t parts) {
  const auto& options = input.options;
  module += "\n  PROC main()\n    CheckRobot;\n    " + options.process_off + ";\n    ConfL\\" +
            (options.monitor_configuration ? "On" : "Off") + ";\n    MoveAbsJ start_axes,feed_1,fine," +
            options.tool_name + "\\WObj:=" + options.workobject_name + ";\n";
  for (std::size_t part = 1; part <= parts; ++part) module += "    Part_" + std::to_string(part) + ";\n";
  module += "    " + options.process_off + ";\n    ConfL\\On;\n  ENDPROC\n";
}

/// The moves of one routine: consecutive, of one segment.
struct Routine {
  std::string name;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Cuts the moves into routines at the ends of segments and at moves_per_routine, and those into modules.
std::vector<std::vector<Routine>> parts(const ProgramInput& input, const std::vector<PlannedMove>& moves) {
  const auto per_routine = static_cast<std::size_t>(input.options.moves_per_routine);
  const auto per_module = static_cast<std::size_t>(input.options.moves_per_module);
  std::vector<std::vector<Routine>> modules(1);
  std::size_t in_module = 0;
  int chunk = 0;
  for (std::size_t begin = 0, end = 0; begin < moves.size(); begin = end) {
    const int segment = moves[begin].segment;
    const bool continues = begin > 0 && moves[begin - 1].segment == segment;
    while (end < moves.size() && moves[end].segment == segment && end - begin < per_routine) ++end;
    chunk = continues ? chunk + 1 : 1;
    if (in_module > 0 && in_module + (end - begin) > per_module) {
      modules.emplace_back();
      in_module = 0;
    }
    in_module += end - begin;
    modules.back().push_back(
        {rapidName("s" + std::to_string(segment) + "_", input.path.segments[segment].name, "_" + std::to_string(chunk)),
         begin, end});
  }
  return modules;
}

class RoutineWriter {
public:
  RoutineWriter(const ProgramInput& input, const std::vector<PlannedMove>& moves, const SpeedTable& speeds)
      : input_(input), moves_(moves), speeds_(speeds) {}

  void append(std::string& module, const Routine& routine) const {
    module += "\n  ! " + asciiLine(input_.path.segments[moves_[routine.begin].segment].name).substr(0, 76) + "\n";
    module += "  PROC " + routine.name + "()\n";
    for (std::size_t i = routine.begin; i < routine.end; ++i) {
      appendSwitches(module, i);
      appendMove(module, moves_[i]);
    }
    module += "  ENDPROC\n";
  }

private:
  void appendSwitches(std::string& module, std::size_t i) const {
    const bool was_on = i > 0 && moves_[i - 1].process_on;
    if (was_on && !moves_[i].process_on) module += "    " + input_.options.process_off + ";\n";
    if (!was_on && moves_[i].process_on) module += "    " + input_.options.process_on + ";\n";
  }

  void appendMove(std::string& module, const PlannedMove& move) const {
    module.append("    MoveL [").append(rapidPosition(move.T_workobject_tcp.translation())).append(",\n      ");
    module.append(rapidOrientation(move.T_workobject_tcp.linear())).append(",");
    module.append(rapidConfiguration(axisConfiguration(input_.robot, move.q))).append(",\n      ");
    module.append(no_external_axes).append("],").append(speeds_.name(move.feed)).append(",");
    module.append(zoneName(move.zone)).append(",\n      ").append(input_.options.tool_name).append("\\WObj:=");
    module.append(input_.options.workobject_name).append(";\n");
  }

  const ProgramInput& input_;
  const std::vector<PlannedMove>& moves_;
  const SpeedTable& speeds_;
};

void appendPart(std::string& module, std::size_t number, const std::vector<Routine>& routines,
                const RoutineWriter& writer) {
  module += "\n  PROC Part_" + std::to_string(number) + "()\n";
  for (const auto& routine : routines) module += "    " + routine.name + ";\n";
  module += "  ENDPROC\n";
  for (const auto& routine : routines) writer.append(module, routine);
}

ProgramFile moduleList(const std::vector<ProgramFile>& modules) {
  std::string text = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\" ?>\n<Program>\n";
  for (const auto& module : modules) text += "\t<Module>" + module.name + "</Module>\n";
  return {"program.pgf", text + "</Program>\n"};
}

std::string mainModule(const ProgramInput& input, const std::vector<PlannedMove>& moves, const SpeedTable& speeds,
                       std::size_t part_count) {
  std::string module = "MODULE ScanToPath\n";
  appendHeader(module, input, moves.size());
  module += "\n";
  appendData(module, input, moves, speeds);
  appendMain(module, input, part_count);
  appendRobotCheck(module, input.options);
  appendProcessRoutine(module, input.options, true);
  appendProcessRoutine(module, input.options, false);
  return module;
}

}  // namespace

std::vector<ProgramFile> writeRapid(const ProgramInput& input) {
  validateProgramOptions(input.options);
  if (input.robot.dof() != 6) {
    throw InputError("robot " + input.robot.name, "number of joints", std::to_string(input.robot.dof()),
                     "6 for a RAPID program");
  }
  const auto moves = plannedMoves(input);
  const SpeedTable speeds(moves);
  const auto modules = parts(input, moves);
  const RoutineWriter writer(input, moves, speeds);
  std::vector<ProgramFile> files;
  for (std::size_t m = 0; m < modules.size(); ++m) {
    const std::string number = std::to_string(m + 1);
    std::string module = m == 0 ? mainModule(input, moves, speeds, modules.size())
                                : "MODULE ScanToPath_" + number + "\n  ! Belongs to ScanToPath in program.mod.\n";
    appendPart(module, m + 1, modules[m], writer);
    module += "ENDMODULE\n";
    files.push_back({m == 0 ? "program.mod" : "program_" + number + ".mod", std::move(module)});
  }
  files.insert(files.begin(), moduleList(files));
  return files;
}

}  // namespace scan_to_path::program
