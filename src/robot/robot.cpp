// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/robot.h"

#include <algorithm>
#include <limits>

#include "chain_walk.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::robot {

namespace {

double coupledAngle(const CoupledAxis& coupled, const JointVector& q) {
  double angle = 0.0;
  for (const int joint : coupled.joints) angle += q[joint];
  return angle;
}

}  // namespace

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

JointVector controllerAxes(const Robot& robot, const JointVector& q) {
  JointVector axes = q;
  if (robot.coupled_axis) axes[robot.coupled_axis->axis] = coupledAngle(*robot.coupled_axis, q);
  return axes;
}

NearestLimit nearestLimit(const Robot& robot, const JointVector& q) {
  NearestLimit nearest;
  const auto look = [&nearest](double angle, double lower, double upper, int joint, bool is_coupled) {
    const double margin = std::min(angle - lower, upper - angle);
    if (margin < nearest.margin) nearest = {margin, angle, lower, upper, joint, is_coupled};
  };
  for (int i = 0; i < robot.dof(); ++i) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(i)];
    look(q[i], joint.lower, joint.upper, i, false);
  }
  if (robot.coupled_axis) {
    const CoupledAxis& coupled = *robot.coupled_axis;
    look(coupledAngle(coupled, q), coupled.lower, coupled.upper, coupled.axis, true);
  }
  return nearest;
}

double coupledMargin(const Robot& robot, const JointVector& q) {
  if (!robot.coupled_axis) return std::numeric_limits<double>::infinity();
  const double angle = coupledAngle(*robot.coupled_axis, q);
  return std::min(angle - robot.coupled_axis->lower, robot.coupled_axis->upper - angle);
}

std::string coupledAxisName(const Robot& robot) {
  std::string sum;
  for (const int joint : robot.coupled_axis->joints) {
    sum += (sum.empty() ? "" : " + ") + robot.joints[static_cast<std::size_t>(joint)].name;
  }
  return "controller axis " + sum;
}

std::string limitName(const Robot& robot, const NearestLimit& limit) {
  return limit.is_coupled ? coupledAxisName(robot) : robot.joints[static_cast<std::size_t>(limit.joint)].name;
}

JointVector largestTurns(const Robot& robot, const JointVector& from, const JointVector& to) {
  const JointVector turns = to - from;
  return turns.cwiseAbs().cwiseMax(controllerAxes(robot, turns).cwiseAbs());
}

}  // namespace scan_to_path::robot
