// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scan_to_path/motion/motion_plan.h"
#include "scan_to_path/program/options.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::program {

using geometry::Frame;
using robot::JointVector;

/// Whose language a program is written in.
enum class Controller { abb };

/// One file of a robot program, named relative to the output directory.
struct ProgramFile {
  std::string name;
  std::string content;
};

/// Everything that a robot program is made from.
struct ProgramInput {
  toolpath::ToolPath path;
  motion::MotionPlan plan;
  robot::Robot robot;
  Frame T_base_path = Frame::Identity();        ///< the path's frame in the robot's base
  Frame T_tip_tcp = Frame::Identity();          ///< tool centre point in the flange frame (tool mount)
  Frame T_base_workobject = Frame::Identity();  ///< the frame in which the program's targets are written
  ProgramOptions options;
  std::vector<std::string> provenance;  ///< lines for the header: input, its SHA-256, versions; no date, no path
  std::vector<std::string> notices;     ///< lines for the header, before those: what whoever runs it must know
};

/// Writes the program for one controller. Throws InputError when the input cannot be a program: numbers that are not
/// finite, a waypoint without joint angles, a feed of 0, above max_speed or above the path's, names the controller
/// would refuse, a path that is not lifted by dry_offset.
std::vector<ProgramFile> writeProgram(Controller controller, const ProgramInput& input);

/// Something that the written program does and the plan does not, or the other way round.
struct Discrepancy {
  int segment = -1;  ///< index into the path's segments; -1: the program as a whole
  int index = -1;    ///< index into the segment's waypoints
  std::string text;  ///< quantity, value found, value planned, limit
};

/// What reading a program back found.
struct ReadBack {
  std::size_t waypoints = 0;  ///< that the program drives to, the axis move to the start apart
  std::vector<Discrepancy> discrepancies;
};

/// Reads the files back with a reader that shares no code with the writer and compares every move with the plan:
/// order, positions to 1 um, angles to 0.001 degree, feeds (the plan's, and none above the path's), process on and off,
/// zones, axis configuration, first joint target (also through forward kinematics), tool, load, ranges of the
/// controller's axes. No discrepancy: the program says what was planned. At most `limit` of them are listed.
ReadBack readBack(Controller controller, const ProgramInput& input, const std::vector<ProgramFile>& files,
                  std::size_t limit = 20);

}  // namespace scan_to_path::program

namespace scan_to_path {
template <>
struct EnumNames<program::Controller> {
  static constexpr std::array<const char*, 1> names = {"abb"};
};
}  // namespace scan_to_path
