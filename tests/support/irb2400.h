// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "scan_to_path/common/random.h"
#include "scan_to_path/robot/axis_coupling.h"
#include "scan_to_path/robot/robot.h"

namespace scan_to_path::test {

inline std::string irb2400File() { return std::string(SCAN_TO_PATH_SOURCE_DIR) + "/urdf/irb2400.urdf"; }

inline robot::Robot irb2400() { return robot::readRobot(irb2400File(), "base_link", "tool0"); }

/// The same with its parallelogram, as the default cell has it.
inline robot::Robot irb2400WithLinkage() {
  robot::Robot robot = irb2400();
  robot.coupled_axis = robot::coupledAxis(robot::AxisCouplingOptions(), robot);
  return robot;
}

/// Forward kinematics of the IRB 2400 from its published dimensions as a product of Denavit-Hartenberg matrices,
/// Rot(z, theta) Trans(z, d) Trans(x, a) Rot(x, alpha): shares nothing with the URDF, the library or KDL.
inline geometry::Frame denavitHartenberg(const double* q) {
  constexpr double a1 = 0.100, a2 = -0.135, c1 = 0.615, c2 = 0.705, c3 = 0.755, c4 = 0.085;
  const double parameters[6][4] = {{q[0], c1, a1, -M_PI_2}, {q[1] - M_PI_2, 0, c2, 0}, {q[2], 0, -a2, -M_PI_2},
                                   {q[3], c3, 0, M_PI_2},   {q[4], 0, 0, -M_PI_2},     {q[5] + M_PI, c4, 0, 0}};
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  for (const auto& [theta, d, a, alpha] : parameters) {
    const double ct = std::cos(theta), st = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
    Eigen::Matrix4d A;
    A << ct, -st * ca, st * sa, a * ct, st, ct * ca, -ct * sa, a * st, 0, sa, ca, d, 0, 0, 0, 1;
    T = T * A;
  }
  return geometry::Frame(T);
}

/// Joint angles within the limits, of the coupled axis too; a continuous joint within one turn.
inline robot::JointVector randomJoints(const robot::Robot& robot, Random& random) {
  robot::JointVector q(robot.dof());
  for (int i = 0; i < robot.dof(); ++i) {
    const auto& joint = robot.joints[static_cast<std::size_t>(i)];
    const bool limited = std::isfinite(joint.upper - joint.lower);
    q[i] = limited ? random.uniform(joint.lower, joint.upper) : random.uniform(-M_PI, M_PI);
  }
  if (robot::coupledMargin(robot, q) < 0.0) return randomJoints(robot, random);
  return q;
}

}  // namespace scan_to_path::test
