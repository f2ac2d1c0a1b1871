// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <nodelet/nodelet.h>
#include <pcl/point_types.h>
#include <pcl_ros/point_cloud.h>
#include <std_srvs/Trigger.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>

#include "scan_to_path/common/error.h"
#include "scan_to_path/scan/sample_log.h"
#include "scan_to_path/sensing/emulate_scan.h"
#include "scan_to_path_ros/log_player.h"
#include "scan_to_path_ros/parameters.h"
#include "tools/emulated_world.h"

namespace scan_to_path_nodelets {

/// A robot that carries a point laser over a part: joint states and range samples with every error of the emulation,
/// the same samples as `scan_to_path emulate` writes; or what a bag recorded. The truth goes to ~truth alone.
class PointLaserEmulator : public nodelet::Nodelet {
  static constexpr const char* sensor_frame = "sensor";

  void onInit() override {
    ros::NodeHandle& own = getPrivateNodeHandle();
    scan_to_path_ros::LogPlayerOptions options;
    options.sensor_frame = sensor_frame;
    options.real_time = scan_to_path_ros::parameter(own, "real_time", options.real_time);
    options.batch = scan_to_path_ros::parameter(own, "batch", options.batch);
    options.window = scan_to_path_ros::parameter(own, "window", options.window);
    options.timeout = scan_to_path_ros::parameter(own, "timeout", options.timeout);
    const auto cell = scan_to_path::pipeline::makeCell(scan_to_path_ros::readJobOptions(getNodeHandle()).cell,
                                                       scan_to_path_ros::packagePath());
    player_ = std::make_unique<scan_to_path_ros::LogPlayer>(getMTNodeHandle(), options, cell.robot);
    truth_ = own.advertise<pcl::PointCloud<pcl::PointXYZ>>("truth/surface", 1, true);
    start_ = getNodeHandle().advertiseService("scan_emulator/start", &PointLaserEmulator::start, this);
    stop_ = getNodeHandle().advertiseService("scan_emulator/stop", &PointLaserEmulator::stop, this);
  }

  bool start(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    try {
      const auto options = scan_to_path_ros::readJobOptions(getNodeHandle());
      const auto cell = scan_to_path::pipeline::makeCell(options.cell, scan_to_path_ros::packagePath());
      auto bag = scan_to_path_ros::jobBag(getNodeHandle());
      if (bag.empty()) bag = scan_to_path_ros::parameter(getPrivateNodeHandle(), "bag", bag);
      player_->start(bag.empty() ? emulate(options, cell) : scan_to_path_ros::recordingFromBag(bag, sensor_frame));
      response.success = 1;
    } catch (const scan_to_path::InputError& error) {
      response.message = error.what();
      NODELET_ERROR("%s", error.what());
    }
    return true;
  }

  scan_to_path_ros::Recording emulate(const scan_to_path::pipeline::JobOptions& options,
                                      const scan_to_path::pipeline::Cell& cell) {
    const auto world = scan_to_path::tools::makeWorld(worldOptions());
    auto emulation = options.emulate;
    if (scan_to_path_ros::parameter(getPrivateNodeHandle(), "raster_height_from_mesh", true) && !mesh().empty()) {
      emulation.raster.height = scan_to_path::tools::rasterHeight(world, cell.laser);
    }
    scan_to_path::tools::checkRasterHeight(world, emulation.raster.height);
    const auto errors = scan_to_path_ros::parameter<std::string>(getPrivateNodeHandle(), "errors", "");
    if (!errors.empty()) {
      const auto set = scan_to_path::parseEnum<scan_to_path::sensing::ErrorSet>("~errors", errors);
      emulation.errors = scan_to_path::sensing::errorPreset(set);
    }
    emulation.seed = getPrivateNodeHandle().param("seed", emulation.seed);
    publishTruth(world, cell);
    const auto emulated =
        scan_to_path::sensing::emulateScan(*world.scene, world.rectangle(), cell.T_base_workpiece, cell.robot,
                                           cell.encoders, cell.laser, cell.T_tip_sensor, emulation, 0);
    // What a log file would hold, so that the command line plans from the very same numbers.
    const auto log =
        scan_to_path::scan::parseSampleLog(scan_to_path::scan::formatSampleLog(emulated.log), "emulated scan");
    return scan_to_path_ros::recordingFromLog(log, cell);
  }

  bool stop(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    player_->stop();
    response.success = 1;
    return true;
  }

  std::string mesh() { return scan_to_path_ros::parameter<std::string>(getPrivateNodeHandle(), "workpiece", ""); }

  scan_to_path::tools::WorldOptions worldOptions() {
    ros::NodeHandle& own = getPrivateNodeHandle();
    scan_to_path::tools::WorldOptions options;
    options.workpiece = mesh();
    const auto units = scan_to_path_ros::parameter<std::string>(own, "workpiece_units", "");
    if (!units.empty())
      options.units = scan_to_path::parseEnum<scan_to_path::pipeline::Units>("workpiece_units", units);
    double number = 0.0;
    if (own.getParam("workpiece_scale", number)) options.scale = number;
    if (own.getParam("table", number)) options.table = number;
    options.no_table = scan_to_path_ros::parameter(own, "no_table", false);
    return options;
  }

  /// Points of the true surface over a grid, for pictures and tests.
  void publishTruth(const scan_to_path::tools::World& world, const scan_to_path::pipeline::Cell& cell) {
    constexpr double step = 0.002;  // [m]
    const auto cloud = boost::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    cloud->header.frame_id = cell.robot.base_link;
    const auto& bounds = world.bounds;
    const double top = bounds.max().z() + 0.1;
    for (double x = bounds.min().x(); x <= bounds.max().x(); x += step) {
      for (double y = bounds.min().y(); y <= bounds.max().y(); y += step) {
        const auto hit = world.scene->castRay({{x, y, top}, -scan_to_path::geometry::Vector3::UnitZ()});
        if (!hit) continue;
        const Eigen::Vector3f p = (cell.T_base_workpiece * hit->point).cast<float>();
        cloud->emplace_back(p.x(), p.y(), p.z());
      }
    }
    truth_.publish(cloud);
  }

  std::unique_ptr<scan_to_path_ros::LogPlayer> player_;
  ros::Publisher truth_;
  ros::ServiceServer start_;
  ros::ServiceServer stop_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::PointLaserEmulator, nodelet::Nodelet)
