// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>

#include "scan_to_path_ros/conversions.h"
#include "scan_to_path_ros/parameters.h"
#include "scan_to_path_ros/stage.h"

namespace scan_to_path_nodelets {

/// A planned path, turned into the joint trajectory of the cell's robot and a verdict for every waypoint.
class MotionPlanner : public nodelet::Nodelet {
  void onInit() override {
    ros::NodeHandle& nodes = getNodeHandle();
    stage_ = std::make_unique<scan_to_path_ros::Stage>(nodes, "motion");
    plan_ = nodes.advertise<scan_to_path::MotionPlan>("motion_plan", 1, true);
    trajectory_ = nodes.advertise<trajectory_msgs::JointTrajectory>("joint_trajectory", 1, true);
    path_ = nodes.subscribe("planned_path", 1, &MotionPlanner::plan, this);
  }

  void plan(const scan_to_path::PlannedPathConstPtr& msg) {
    stage_->run(msg->header, [&](const scan_to_path::Progress& progress) {
      const auto options = scan_to_path_ros::readJobOptions(getNodeHandle());
      const auto cell = scan_to_path::pipeline::makeCell(options.cell, scan_to_path_ros::packagePath());
      const auto driven = scan_to_path::pipeline::airRun(scan_to_path_ros::fromMsg(*msg), cell, options.program);
      const auto motion = scan_to_path::pipeline::motionStage(driven, cell, options, progress);
      trajectory_.publish(boost::make_shared<trajectory_msgs::JointTrajectory>(
          scan_to_path_ros::toJointTrajectory(motion.plan.trajectory, msg->header)));
      plan_.publish(boost::make_shared<scan_to_path::MotionPlan>(scan_to_path_ros::toMsg(motion, msg->header)));
    });
  }

  std::unique_ptr<scan_to_path_ros::Stage> stage_;
  ros::Publisher plan_;
  ros::Publisher trajectory_;
  ros::Subscriber path_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::MotionPlanner, nodelet::Nodelet)
