// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/robot/robot.h"

namespace scan_to_path::robot {

/// What the robot description cannot say: which of the controller's axes turns with more than one joint. One axis that
/// is a plain sum of joints is all that there is; gears between wrist axes are not of this form. The default is
/// the shipped arm's, whose parallelogram keeps the upper arm's slope when axis 2 moves (ABB, IRB 2400 product
/// specification: axis 3 from -60 to +65 degrees against the horizontal).
struct AxisCouplingOptions {
  std::string robot = "irb2400";
  std::string axis = "joint_3";
  std::vector<std::string> joints = {"joint_2", "joint_3"};
  double lower = -1.0471975511965976;
  double upper = 1.1344640137963142;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.robot, Field{"robot", "", "name, in its URDF, of the arm that this is said of"});
    visit(self.axis,
          Field{"axis", "", "joint in whose place the controller counts the sum of `joints`; empty: no such axis"});
    visit(self.joints,
          Field{"joints", "", "joints that sum to the controller's axis, the one it stands for among them"});
    visit(self.lower, Field{"lower", "rad", "limit of the controller's axis", -1000.0, 1000.0});
    visit(self.upper, Field{"upper", "rad", "limit of the controller's axis", -1000.0, 1000.0});
  }
};

/// The declaration for this robot; nothing when `axis` is empty. Throws InputError, its names led by
/// "cell.axis_coupling", for a robot of another name (the controller of one arm says nothing about another's), joints
/// that are not in its chain or stand twice, fewer than two, the axis not among them, limits that do not rise.
std::optional<CoupledAxis> coupledAxis(const AxisCouplingOptions& options, const Robot& robot);

}  // namespace scan_to_path::robot
