// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <nodelet/nodelet.h>
#include <robot_state_publisher/robot_state_publisher.h>
#include <sensor_msgs/JointState.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_msgs/TFMessage.h>
#include <kdl_parser/kdl_parser.hpp>
#include <pluginlib/class_list_macros.hpp>

#include <cmath>
#include <memory>

#include "scan_to_path/common/error.h"
#include "scan_to_path/robot/kdl_chain.h"
#include "scan_to_path_ros/parameters.h"

namespace scan_to_path_nodelets {

/// A frame that stays where it is in another.
geometry_msgs::TransformStamped fixedFrame(const std::string& parent, const std::string& child,
                                           const scan_to_path::geometry::Frame& T) {
  geometry_msgs::TransformStamped msg = tf2::eigenToTransform(T);
  msg.header.frame_id = parent;
  msg.header.stamp = ros::Time::now();
  msg.child_frame_id = child;
  return msg;
}

/// The robot's links in tf2. All that is fixed goes out in one message: of a latched topic, whoever comes late gets the
/// last message alone.
class RobotFrames : public robot_state_publisher::RobotStatePublisher {
public:
  using RobotStatePublisher::RobotStatePublisher;

  void publishFixed(std::vector<geometry_msgs::TransformStamped> mounts) {
    for (const auto& entry : segments_fixed_) {
      const auto& segment = entry.second;
      mounts.push_back(fixedFrame(segment.root, segment.tip, scan_to_path::robot::fromKdl(segment.segment.pose(0))));
    }
    static_tf_broadcaster_.sendTransform(mounts);
  }
};

/// The cell in tf2: the robot's links for every joint reading, none left out however fast they come (the node of
/// robot_state_publisher keeps one and throttles), and the fixed frames sensor, tcp and workpiece.
class CellFrames : public nodelet::Nodelet {
  static constexpr int queue = 20000;  ///< joint readings, and their transforms: 20 s at 1 kHz

  void onInit() override {
    const auto options = scan_to_path_ros::readJobOptions(getNodeHandle());
    const auto path = scan_to_path_ros::packagePath();
    const auto cell = scan_to_path::pipeline::makeCell(options.cell, path);
    KDL::Tree tree;
    urdf::Model model;
    const auto file = scan_to_path::pipeline::resolveFile(options.cell.robot, path);
    if (!model.initFile(file.string()) || !kdl_parser::treeFromUrdfModel(model, tree)) {
      throw scan_to_path::InputError(file.string() + ": no robot that tf2 can show");
    }
    // Who advertises first says how many wait for another process or host; tf2's own broadcaster would keep 100.
    transforms_ = getNodeHandle().advertise<tf2_msgs::TFMessage>("/tf", queue);
    robot_ = std::make_unique<RobotFrames>(tree, model);
    publishFixed(options.cell, cell);
    joints_ = getNodeHandle().subscribe("joint_states", queue, &CellFrames::publish, this);
  }

  void publishFixed(const scan_to_path::pipeline::CellOptions& options, const scan_to_path::pipeline::Cell& cell) {
    robot_->publishFixed({fixedFrame(options.tip_link, "sensor", cell.T_tip_sensor),
                          fixedFrame(options.tip_link, "tcp", cell.T_tip_tcp),
                          fixedFrame(options.base_link, "workpiece", cell.T_base_workpiece)});
  }

  void publish(const sensor_msgs::JointStateConstPtr& joints) {
    if (joints->name.size() != joints->position.size()) {
      NODELET_ERROR_THROTTLE(1.0, "joint states with %zu names and %zu positions are left out", joints->name.size(),
                             joints->position.size());
      return;
    }
    for (std::size_t i = 0; i < joints->name.size(); ++i) {
      if (std::isfinite(joints->position[i])) continue;
      NODELET_ERROR_THROTTLE(1.0, "joint states with %s at %f are left out", joints->name[i].c_str(),
                             joints->position[i]);
      return;
    }
    std::map<std::string, double> positions;
    for (std::size_t i = 0; i < joints->name.size(); ++i) positions.emplace(joints->name[i], joints->position[i]);
    robot_->publishTransforms(positions, joints->header.stamp);
  }

  ros::Publisher transforms_;
  std::unique_ptr<RobotFrames> robot_;
  ros::Subscriber joints_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::CellFrames, nodelet::Nodelet)
