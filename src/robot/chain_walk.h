// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "scan_to_path/robot/robot.h"

namespace scan_to_path::robot {

/// Rotation by `angle` about the unit vector `a` (Rodrigues).
inline Eigen::Matrix3d axisRotation(const Vector3& a, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  const Vector3 va = (1.0 - c) * a, sa = s * a;
  Eigen::Matrix3d R;
  R << va.x() * a.x() + c, va.x() * a.y() - sa.z(), va.x() * a.z() + sa.y(),  //
      va.x() * a.y() + sa.z(), va.y() * a.y() + c, va.y() * a.z() - sa.x(),   //
      va.x() * a.z() - sa.y(), va.y() * a.z() + sa.x(), va.z() * a.z() + c;
  return R;
}

/// T_base_tip for q; `visit(i, origin, axis)` sees every joint's origin and axis in base coordinates on the way.
template <class Visitor>
Frame walkChain(const Robot& robot, const double* q, Visitor&& visit) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Vector3 p = Vector3::Zero();
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    p += R * joint.T_parent_joint.translation();
    const Eigen::Matrix3d R_joint = R * joint.T_parent_joint.linear();
    visit(static_cast<int>(i), p, R_joint, joint.axis);
    R.noalias() = R_joint * axisRotation(joint.axis, q[i]);
  }
  Frame T;
  T.linear().noalias() = R * robot.T_last_tip.linear();
  T.translation() = p + R * robot.T_last_tip.translation();
  T.makeAffine();
  return T;
}

}  // namespace scan_to_path::robot
