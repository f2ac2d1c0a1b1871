// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/robot.h"

#include <algorithm>
#include <limits>

#include "chain_walk.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::robot {

Robot readRobot(const std::filesystem::path& file, const std::string& base_link, const std::string& tip_link) {
  const std::string urdf = readFile(file);
  try {
    return parseRobot(urdf, base_link, tip_link);
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

Frame forwardKinematics(const Robot& robot, const double* q) {
  return walkChain(robot, q, [](int, const Vector3&, const Eigen::Matrix3d&, const Vector3&) {});
}

Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 8> jacobian(const Robot& robot, const JointVector& q) {
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 8> J(6, robot.dof());
  const Frame T_base_tip =
      walkChain(robot, q.data(), [&](int i, const Vector3& p, const Eigen::Matrix3d& R, const Vector3& axis) {
        J.col(i).head<3>() = p;
        J.col(i).tail<3>() = R * axis;
      });
  for (int i = 0; i < robot.dof(); ++i) {
    const Vector3 origin = J.col(i).head<3>(), axis = J.col(i).tail<3>();
    J.col(i).head<3>() = axis.cross(T_base_tip.translation() - origin);
  }
  return J;
}

double limitMargin(const Robot& robot, const JointVector& q, int* joint) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < robot.dof(); ++i) {
    const Joint& limits = robot.joints[static_cast<std::size_t>(i)];
    const double margin = std::min(q[i] - limits.lower, limits.upper - q[i]);
    if (i > 0 && margin >= least) continue;
    least = margin;
    if (joint != nullptr) *joint = i;
  }
  return least;
}

}  // namespace scan_to_path::robot
