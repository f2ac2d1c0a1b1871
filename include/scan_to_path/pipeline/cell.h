// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/robot/axis_coupling.h"
#include "scan_to_path/robot/encoders.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/sensing/point_laser.h"

namespace scan_to_path::pipeline {

using geometry::Frame;
using geometry::Vector3;

/// Where something is fixed: its pose in a parent frame.
struct MountOptions {
  std::string parent;
  Vector3 xyz = Vector3::Zero();
  Vector3 rpy = Vector3::Zero();

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.parent, Field{"parent", "", "frame it is fixed to"});
    visit(self.xyz, Field{"xyz", "m", "position in the parent"});
    visit(self.rpy, Field{"rpy", "rad", "roll, pitch, yaw in the parent, about fixed axes", -7.0, 7.0});
  }

  geometry::Frame frame() const { return geometry::makeFrame(xyz, rpy); }  ///< in the parent
};

/// The robot cell. The shipped arm, a laser looking along the flange's axis beside a ball-nosed tool, a part in front.
struct CellOptions {
  std::string robot = "package://scan_to_path/urdf/irb2400.urdf";
  std::string base_link = "base_link";
  std::string tip_link = "tool0";
  robot::AxisCouplingOptions axis_coupling;
  robot::EncoderOptions encoders;
  sensing::PointLaserOptions laser;
  MountOptions sensor{"tool0", Vector3(0.08, 0.0, 0.12), Vector3::Zero()};
  MountOptions tool{"tool0", Vector3(0.0, 0.0, 0.20), Vector3::Zero()};
  MountOptions workpiece{"base_link", Vector3(0.85, -0.08, 0.45), Vector3::Zero()};

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.robot, Field{"robot", "", "URDF file, or package://PACKAGE/FILE"});
    visit(self.base_link, Field{"base_link", "", "link that scans and paths are in"});
    visit(self.tip_link, Field{"tip_link", "", "flange, where sensor and tool are mounted"});
    visit(self.axis_coupling, Field{"axis_coupling"});
    visit(self.encoders, Field{"encoders"});
    visit(self.laser, Field{"laser"});
    visit(self.sensor, Field{"sensor"});
    visit(self.tool, Field{"tool"});
    visit(self.workpiece, Field{"workpiece"});
  }
};

/// The cell as the stages use it.
struct Cell {
  robot::Robot robot;
  robot::Encoders encoders;
  sensing::PointLaserOptions laser;
  Frame T_tip_sensor = Frame::Identity();
  Frame T_tip_tcp = Frame::Identity();
  Frame T_base_workpiece = Frame::Identity();
  robot::EncoderOptions encoder_options;  ///< what `encoders` was made from, for checks that do not trust it
};

/// Reads the robot and checks that everything fits together. package:// is looked up in `package_path` (directories
/// that are a package or hold packages). Throws InputError for a file or package that is not there, an axis_coupling
/// that is not this robot's, mounts with a parent other than tip_link (sensor, tool) or base_link (workpiece), and
/// links of the URDF called sensor, tcp or workpiece, which are this cell's own frames.
Cell makeCell(const CellOptions& options, const std::vector<std::filesystem::path>& package_path);

/// The file that a plain path or a package:// address names. Throws InputError when no package of that name is found.
std::filesystem::path resolveFile(const std::string& address, const std::vector<std::filesystem::path>& package_path);

}  // namespace scan_to_path::pipeline
