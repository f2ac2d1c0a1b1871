// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scan_to_path/geometry/frames.h"
#include "scan_to_path/program/program.h"

namespace scan_to_path::program {

/// Tool data of a RAPID program.
struct RapidTool {
  std::string name;
  Frame T_tip_tcp = Frame::Identity();
  double mass = 0.0;                                                ///< [kg]
  geometry::Vector3 centre_of_gravity = geometry::Vector3::Zero();  ///< in the flange frame [m]
  geometry::Vector3 inertia = geometry::Vector3::Zero();            ///< [kg m^2]
};

enum class RapidMoveType { absolute_joint, joint, linear };  // MoveAbsJ, MoveJ, MoveL

/// One move, in the order in which `main` drives it.
struct RapidMove {
  RapidMoveType type = RapidMoveType::linear;
  Frame T_base_tcp = Frame::Identity();  ///< target; identity for absolute_joint
  std::array<double, 6> axes{};          ///< target as the controller counts axes [rad]; for absolute_joint
  std::array<int, 4> configuration{};    ///< cf1, cf4, cf6, cfx
  double speed = 0.0;                    ///< [m/s]
  double orientation_speed = 0.0;        ///< [rad/s]
  bool stop = false;                     ///< a stop point (fine)
  double zone = 0.0;                     ///< radius of the path zone [m]; 0 at a stop point
  bool process_on = false;               ///< while driving to the target
  double process_wait = 0.0;             ///< waited since the process was switched on, before this move [s]
  bool after_stop = false;               ///< the program waits for the operator (Stop) before it
  int tool = 0;                          ///< index into RapidProgram::tools
  std::string file;
  int line = 0;
};

struct RapidProgram {
  std::vector<RapidMove> moves;
  std::vector<RapidTool> tools;  ///< those that moves use
};

/// What means "process on" in the program.
struct RapidReadOptions {
  std::string process_on = "ProcessOn";    ///< routine that starts the process; looked into for waits only
  std::string process_off = "ProcessOff";  ///< routine that stops it
  std::string process_signal;              ///< digital output that stands for the process; empty: none
  std::size_t max_steps = 50000000;        ///< instructions and expression nodes before giving up
};

/// Reads the modules and follows `main` without a robot: MoveAbsJ, MoveJ and MoveL with declared or literal targets,
/// Offs and RelTool (shift), tools, work objects, speed and zone data declared or predefined, routine calls, SetDO,
/// WaitTime.
/// Files that do not end in .mod are passed over. World and robot base are taken to coincide.
/// Throws InputError with file and line for text that is no RAPID, for anything outside that subset that could change
/// a motion (loops, motion under a condition, MoveC, data assigned at run time and then used in a move, …).
RapidProgram readRapid(const std::vector<ProgramFile>& files, const RapidReadOptions& options = {});

}  // namespace scan_to_path::program
