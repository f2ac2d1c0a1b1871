// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/axis_configuration.h"

#include <array>
#include <cmath>

#include "scan_to_path/common/angles.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path::program {
namespace {

constexpr double boundary_tolerance = 1e-7;

/// A joint's origin and axis in the robot's base.
struct Axis {
  geometry::Vector3 origin;
  geometry::Vector3 direction;
};

std::array<Axis, 6> axesInBase(const robot::Robot& robot, const robot::JointVector& q) {
  std::array<Axis, 6> axes;
  geometry::Frame T_base_joint = geometry::Frame::Identity();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto& joint = robot.joints[i];
    T_base_joint = T_base_joint * joint.T_parent_joint;
    axes[i] = {T_base_joint.translation(), T_base_joint.linear() * joint.axis};
    T_base_joint = T_base_joint * Eigen::AngleAxisd(q[static_cast<int>(i)], joint.axis);
  }
  return axes;
}

}  // namespace

int axisQuadrant(double angle) { return static_cast<int>(std::floor((angle + boundary_tolerance) / right_angle)); }

AxisConfiguration axisConfiguration(const robot::Robot& robot, const robot::JointVector& q) {
  if (robot.dof() != 6 || q.size() != 6) {
    throw InputError("robot " + robot.name, "number of joints", std::to_string(robot.dof()),
                     "6 for an axis configuration");
  }
  const auto axes = axesInBase(robot, q);
  const auto& shoulder = axes[1].origin;
  const auto& elbow = axes[2].origin;
  const auto& wrist = axes[4].origin;
  // Lateral axis times vertical axis is the direction in which axis 1 points the arm.
  const geometry::Vector3 forward = axes[1].direction.cross(axes[0].direction);
  const bool behind_axis_1 = forward.dot(wrist - axes[0].origin) < 0.0;
  const bool behind_lower_arm = (elbow - shoulder).cross(wrist - shoulder).dot(axes[1].direction) < 0.0;
  const bool wrist_negative = q[4] < -boundary_tolerance;
  return {axisQuadrant(q[0]), axisQuadrant(q[3]), axisQuadrant(q[5]),
          (behind_axis_1 ? 4 : 0) + (behind_lower_arm ? 2 : 0) + (wrist_negative ? 1 : 0)};
}

}  // namespace scan_to_path::program
