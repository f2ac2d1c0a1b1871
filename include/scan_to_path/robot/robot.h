// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::robot {

using geometry::Frame;
using geometry::Vector3;

constexpr int max_joints = 8;

/// One value per movable joint, base to tip [rad]. It never allocates.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_joints, 1>;

/// From joints to joints, in its upper left corner; identity beyond.
using JointMatrix = Eigen::Matrix<double, max_joints, max_joints>;

/// A revolute joint of the chain.
struct Joint {
  std::string name;
  Frame T_parent_joint = Frame::Identity();  ///< from the previous movable joint's frame (base_link for the first)
  Vector3 axis = Vector3::UnitZ();           ///< unit, in the joint's frame
  double lower = 0.0;                        ///< [rad]; -inf for a continuous joint
  double upper = 0.0;                        ///< [rad]; +inf for a continuous joint
  double max_velocity = 0.0;                 ///< [rad/s]
};

/// An axis of the controller that turns with several joints of the chain: its angle is their sum. A parallelogram that
/// moves the upper arm, for one, makes axis 3 the angle against the horizontal, joint_2 + joint_3.
struct CoupledAxis {
  int axis = 0;             ///< index of the joint in whose place the controller counts it
  std::vector<int> joints;  ///< indices of the joints that sum to it, `axis` among them
  double lower = 0.0;       ///< its own range [rad], beside the joints'
  double upper = 0.0;       ///< [rad]
};

/// The serial chain from base_link to tip_link.
struct Robot {
  std::string name;
  std::string base_link;
  std::string tip_link;
  std::vector<std::string> link_names;  ///< every link of the URDF, for name clashes
  std::vector<Joint> joints;
  Frame T_last_tip = Frame::Identity();     ///< tip_link in the last movable joint's frame
  std::optional<CoupledAxis> coupled_axis;  ///< a URDF does not say it: see axis_coupling.h

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

/// Joint angles as the controller counts them [rad]: q, with the coupled axis in its joint's place.
JointVector controllerAxes(const Robot& robot, const JointVector& q);

/// The limit that joint angles come nearest to: a joint's, or that of the controller's coupled axis.
struct NearestLimit {
  double margin = std::numeric_limits<double>::infinity();  ///< [rad]; negative outside
  double angle = 0.0;                                       ///< of the joint or axis [rad]
  double lower = 0.0;                                       ///< [rad]
  double upper = 0.0;                                       ///< [rad]
  int joint = 0;                                            ///< index; of a coupled axis its `axis`
  bool is_coupled = false;
};

NearestLimit nearestLimit(const Robot& robot, const JointVector& q);

/// How far the nearest joint or coupled axis is inside its limits [rad]; negative outside.
inline double limitMargin(const Robot& robot, const JointVector& q) { return nearestLimit(robot, q).margin; }

/// How far the coupled axis is inside its limits [rad]; infinite without one.
double coupledMargin(const Robot& robot, const JointVector& q);

/// "controller axis joint_2 + joint_3", for messages; needs a coupled axis.
std::string coupledAxisName(const Robot& robot);

/// The limited joint's name, or coupledAxisName.
std::string limitName(const Robot& robot, const NearestLimit& limit);

/// How far each joint turns from one configuration to another, or the controller's axis in its place if that is more
/// [rad]: what speed limits hold for.
JointVector largestTurns(const Robot& robot, const JointVector& from, const JointVector& to);

}  // namespace scan_to_path::robot
