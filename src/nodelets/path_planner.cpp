// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>

#include "scan_to_path_ros/conversions.h"
#include "scan_to_path_ros/parameters.h"
#include "scan_to_path_ros/region_marker.h"
#include "scan_to_path_ros/stage.h"

namespace scan_to_path_nodelets {

/// A fitted scan, turned into the tool path of the process.
class PathPlanner : public nodelet::Nodelet {
  void onInit() override {
    ros::NodeHandle& nodes = getNodeHandle();
    stage_ = std::make_unique<scan_to_path_ros::Stage>(nodes, "path");
    planned_ = nodes.advertise<scan_to_path::PlannedPath>("planned_path", 1, true);
    path_ = nodes.advertise<scan_to_path::ToolPath>("tool_path", 1, true);
    region_ = nodes.advertise<visualization_msgs::Marker>("region", 1, true);
    scan_ = nodes.subscribe("fitted_scan", 1, &PathPlanner::plan, this);
  }

  void plan(const scan_to_path::FittedScanConstPtr& msg) {
    stage_->run(msg->header, [&](const scan_to_path::Progress& progress) {
      const auto options = scan_to_path_ros::readJobOptions(getNodeHandle());
      const auto process = scan_to_path_ros::parameter<std::string>(getNodeHandle(), "process", "cutting");
      const auto fitted = scan_to_path_ros::fromMsg(*msg);
      region_.publish(scan_to_path_ros::regionMarker(options, fitted.scan, msg->header));
      const auto planner = scan_to_path::pipeline::makePlanner(process, options);
      const auto planned =
          scan_to_path::pipeline::pathStage(*planner, fitted.scan, msg->header.frame_id, options, progress);
      const auto out = boost::make_shared<scan_to_path::PlannedPath>(scan_to_path_ros::toMsg(planned, msg->header));
      path_.publish(boost::make_shared<scan_to_path::ToolPath>(out->path));
      planned_.publish(out);
    });
  }

  std::unique_ptr<scan_to_path_ros::Stage> stage_;
  ros::Publisher planned_;
  ros::Publisher path_;
  ros::Publisher region_;
  ros::Subscriber scan_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::PathPlanner, nodelet::Nodelet)
