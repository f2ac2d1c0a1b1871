// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::robot {

using geometry::Frame;
using geometry::Vector3;

/// One value per movable joint, base to tip [rad]. At most eight joints, so it never allocates.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1>;

/// A revolute joint of the chain.
struct Joint {
  std::string name;
  Frame T_parent_joint = Frame::Identity();  ///< from the previous movable joint's frame (base_link for the first)
  Vector3 axis = Vector3::UnitZ();           ///< unit, in the joint's frame
  double lower = 0.0;                        ///< [rad]; -inf for a continuous joint
  double upper = 0.0;                        ///< [rad]; +inf for a continuous joint
  double max_velocity = 0.0;                 ///< [rad/s]
};

/// The serial chain from base_link to tip_link.
struct Robot {
  std::string name;
  std::string base_link;
  std::string tip_link;
  std::vector<std::string> link_names;  ///< every link of the URDF, for name clashes
  std::vector<Joint> joints;
  Frame T_last_tip = Frame::Identity();  ///< tip_link in the last movable joint's frame

  int dof() const { return static_cast<int>(joints.size()); }
};

/// Reads the chain from a URDF text. Throws InputError for text that is no URDF (an xacro file is named as such),
/// missing links, no path between them, prismatic or mimic joints, more than eight joints, absent limits.
Robot parseRobot(const std::string& urdf, const std::string& base_link, const std::string& tip_link);
Robot readRobot(const std::filesystem::path& file, const std::string& base_link, const std::string& tip_link);

/// T_base_tip for joint angles q[0 … dof) [rad] (seed 000 eq. 1). About 0.2 us for six axes.
Frame forwardKinematics(const Robot& robot, const double* q);
inline Frame forwardKinematics(const Robot& robot, const JointVector& q) { return forwardKinematics(robot, q.data()); }

/// 6 x dof geometric Jacobian of the tip in base coordinates: rows are linear [m/rad], then angular velocity.
Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 8> jacobian(const Robot& robot, const JointVector& q);

/// How far the nearest joint is inside its limits [rad]; negative outside. `joint` gets its index when not null.
double limitMargin(const Robot& robot, const JointVector& q, int* joint = nullptr);

}  // namespace scan_to_path::robot
