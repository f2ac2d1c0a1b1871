// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/kdl_chain.h"

namespace scan_to_path::robot {

KDL::Frame toKdl(const Frame& T) {
  const Eigen::Matrix3d R = T.linear();
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
          KDL::Vector(T.translation().x(), T.translation().y(), T.translation().z())};
}

Frame fromKdl(const KDL::Frame& T) {
  Frame frame = Frame::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) frame.linear()(row, column) = T.M(row, column);
    frame.translation()[row] = T.p(row);
  }
  return frame;
}

KDL::Chain kdlChain(const Robot& robot) {
  KDL::Chain chain;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    const KDL::Frame T = toKdl(joint.T_parent_joint);
    const KDL::Vector axis(joint.axis.x(), joint.axis.y(), joint.axis.z());
    const bool is_last = i + 1 == robot.joints.size();
    chain.addSegment(KDL::Segment(joint.name, KDL::Joint(joint.name, T.p, T.M * axis, KDL::Joint::RotAxis),
                                  is_last ? T * toKdl(robot.T_last_tip) : T));
  }
  return chain;
}

}  // namespace scan_to_path::robot
