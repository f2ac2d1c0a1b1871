// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <nodelet/nodelet.h>
#include <pcl_ros/point_cloud.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>

#include "scan_to_path/scan/scan_cloud.h"
#include "scan_to_path_ros/conversions.h"
#include "scan_to_path_ros/parameters.h"
#include "scan_to_path_ros/stage.h"

namespace scan_to_path_nodelets {

/// A scan cloud and what belongs to it, turned into fitted lines, outline and surface.
class SurfaceFitter : public nodelet::Nodelet {
  using Cloud = scan_to_path::scan::ScanCloud;
  using Info = scan_to_path::ScanInfo;

  void onInit() override {
    ros::NodeHandle& nodes = getNodeHandle();
    stage_ = std::make_unique<scan_to_path_ros::Stage>(nodes, "fit");
    fitted_ = nodes.advertise<scan_to_path::FittedScan>("fitted_scan", 1, true);
    cloud_.subscribe(nodes, "scan_cloud", 1);
    info_.subscribe(nodes, "scan_info", 1);
    scans_.connectInput(cloud_, info_);
    scans_.registerCallback(&SurfaceFitter::fit, this);
  }

  void fit(const boost::shared_ptr<const Cloud>& cloud, const boost::shared_ptr<const Info>& info) {
    stage_->run(info->header, [&](const scan_to_path::Progress& progress) {
      const auto options = scan_to_path_ros::readJobOptions(getNodeHandle());
      const auto scanned = scan_to_path_ros::scanStage(cloud, *info);
      const int threads = scan_to_path_ros::parameter(getPrivateNodeHandle(), "threads", 0);
      const auto fitted =
          scan_to_path::pipeline::fitStage(scanned, options.scan, options.fit, options.report, threads, progress);
      fitted_.publish(boost::make_shared<scan_to_path::FittedScan>(scan_to_path_ros::toMsg(fitted, info->header)));
    });
  }

  std::unique_ptr<scan_to_path_ros::Stage> stage_;
  ros::Publisher fitted_;
  message_filters::Subscriber<Cloud> cloud_;
  message_filters::Subscriber<Info> info_;
  message_filters::TimeSynchronizer<Cloud, Info> scans_{2};
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::SurfaceFitter, nodelet::Nodelet)
