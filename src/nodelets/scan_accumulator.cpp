// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <nodelet/nodelet.h>
#include <pcl_conversions/pcl_conversions.h>
#include <pcl_ros/point_cloud.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>
#include <pluginlib/class_list_macros.hpp>

#include <map>
#include <memory>

#include "scan_to_path/common/error.h"
#include "scan_to_path_ros/conversions.h"
#include "scan_to_path_ros/parameters.h"
#include "scan_to_path_ros/sample_placer.h"
#include "scan_to_path_ros/stage.h"

namespace scan_to_path_nodelets {

/// Range samples and tf2, made into a scan cloud: new points for display as they come, the whole cloud when told to
/// finish, with what could not be placed.
class ScanAccumulator : public nodelet::Nodelet {
  using Cloud = scan_to_path::scan::ScanCloud;
  static constexpr double live_period = 0.1;  ///< [s]; rviz shows what was measured less than 0.2 s ago

  void onInit() override {
    ros::NodeHandle& nodes = getNodeHandle();
    placer_.restart(placerOptions());
    stage_ = std::make_unique<scan_to_path_ros::Stage>(nodes, "scan");
    scan_ = nodes.advertise<Cloud>("scan_cloud", 1, true);
    info_ = nodes.advertise<scan_to_path::ScanInfo>("scan_info", 1, true);
    live_ = nodes.advertise<Cloud>("scan_points", 100);
    acknowledged_ = nodes.advertise<std_msgs::Header>("scan_acknowledged", 10);
    recording_told_ = nodes.advertise<std_msgs::Bool>("scan_recording", 1, true);
    transforms_ = nodes.subscribe("/tf", 20000, &ScanAccumulator::addTransforms, this);
    static_transforms_ = nodes.subscribe("/tf_static", 100, &ScanAccumulator::addStaticTransforms, this);
    samples_ = nodes.subscribe("scan_samples", 20000, &ScanAccumulator::addSamples, this);
    live_timer_ = nodes.createWallTimer(ros::WallDuration(live_period), &ScanAccumulator::publishLive, this);
    setRecording(false);
    // Last: who finds them may start a scan at once.
    start_ = nodes.advertiseService("scan_accumulator/start", &ScanAccumulator::start, this);
    stop_ = nodes.advertiseService("scan_accumulator/stop", &ScanAccumulator::stop, this);
    finish_ = nodes.advertiseService("scan_accumulator/finish", &ScanAccumulator::finish, this);
  }

  /// Latched: whoever moves a real robot knows by it when to begin.
  void setRecording(bool recording) {
    recording_ = recording;
    std_msgs::Bool message;
    message.data = static_cast<std::uint8_t>(recording);
    recording_told_.publish(message);
  }

  bool start(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    try {
      placer_.restart(placerOptions());
      published_ = 0;
      refused_.clear();
      setRecording(true);
      response.success = 1;
    } catch (const scan_to_path::InputError& error) {
      response.message = error.what();
    }
    return true;
  }

  /// Forgets the scan of a job that came to no end.
  bool stop(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    if (recording_) {
      placer_.restart(placer_.options());
      published_ = 0;
      setRecording(false);
    }
    response.success = 1;
    return true;
  }

  bool finish(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    if (!recording_) {
      response.message = "not recording";
      return true;
    }
    setRecording(false);
    publishLive(ros::WallTimerEvent());
    std_msgs::Header header;
    header.stamp = placer_.start();
    header.frame_id = placer_.options().base_frame;
    const std::size_t samples = placer_.samplesIn();
    response.success = static_cast<std::uint8_t>(stage_->run(header, [&](const scan_to_path::Progress&) {
      placer_.finish();
      auto scanned = placer_.take();
      if (!refused_.empty()) scanned.notes.push_back("samples refused: " + refused_);
      // PCL's stamps count microseconds: both messages carry the same one.
      header.stamp = pcl_conversions::fromPCL(scanned.cloud->header.stamp);
      info_.publish(boost::make_shared<scan_to_path::ScanInfo>(scan_to_path_ros::toInfo(scanned, header)));
      scan_.publish(boost::shared_ptr<const Cloud>(scanned.cloud.get(), [kept = scanned.cloud](const Cloud*) {}));
    }));
    response.message = response.success != 0 ? std::to_string(samples) + " samples" : stage_->error();
    return true;
  }

  scan_to_path_ros::SamplePlacerOptions placerOptions() {
    const auto options = scan_to_path_ros::readJobOptions(getNodeHandle());
    scan_to_path_ros::SamplePlacerOptions placing;
    placing.base_frame = options.cell.base_link;
    placing.max_joint_gap = options.scan.placement.max_joint_gap;
    placing.max_joint_jump = options.scan.placement.max_joint_jump;
    placing.limits = options.report;
    placing.clock_offset = options.scan.placement.clock_offset.value_or(0.0);
    const auto range = scan_to_path::sensing::measuringRange(options.cell.laser);
    placing.range_min = range.nearest;
    placing.range_max = range.farthest;
    placing.max_wait = scan_to_path_ros::parameter(getPrivateNodeHandle(), "max_wait", placing.max_wait);
    return placing;
  }

  void addTransforms(const tf2_msgs::TFMessageConstPtr& message) {
    for (const auto& transform : message->transforms) placer_.addTransform(transform, false);
    acknowledge();
  }

  void addStaticTransforms(const tf2_msgs::TFMessageConstPtr& message) {
    for (const auto& transform : message->transforms) placer_.addTransform(transform, true);
    acknowledge();
  }

  void addSamples(const scan_to_path::ScanSamplesConstPtr& samples) {
    if (!recording_) return;
    try {
      placer_.addSamples(*samples);
    } catch (const scan_to_path::InputError& error) {
      refused_ = error.what();
      NODELET_ERROR_THROTTLE(1.0, "%s", error.what());
    }
    acknowledge();
  }

  /// Tells how far the scan is placed: an emulator faster than real time waits for it, a job knows when all is there.
  void acknowledge() {
    if (!recording_ || placer_.acknowledged().isZero() || placer_.acknowledged() == told_) return;
    told_ = placer_.acknowledged();
    auto header = boost::make_shared<std_msgs::Header>();
    header->stamp = told_;
    header->frame_id = placer_.options().base_frame;
    acknowledged_.publish(header);
  }

  void publishLive(const ros::WallTimerEvent&) {
    diagnose();
    const Cloud& cloud = placer_.cloud();
    if (published_ >= cloud.size()) return;
    const auto points = boost::make_shared<Cloud>();
    points->header = cloud.header;
    pcl_conversions::toPCL(placer_.acknowledged(), points->header.stamp);
    points->points.assign(cloud.points.begin() + static_cast<std::ptrdiff_t>(published_), cloud.points.end());
    points->width = static_cast<std::uint32_t>(points->points.size());
    points->height = 1;
    published_ = cloud.size();
    live_.publish(points);
  }

  void diagnose() {
    std::map<std::string, std::string> details = {{"recording", recording_ ? "yes" : "no"},
                                                  {"samples", std::to_string(placer_.samplesIn())},
                                                  {"placed", std::to_string(placer_.cloud().size())},
                                                  {"waiting for transforms", std::to_string(placer_.waiting())},
                                                  {"refused", refused_}};
    for (const auto& entry : placer_.dropped()) details["dropped, " + entry.reason] = std::to_string(entry.count);
    stage_->setDetails(details);
  }

  scan_to_path_ros::SamplePlacer placer_{scan_to_path_ros::SamplePlacerOptions()};
  std::unique_ptr<scan_to_path_ros::Stage> stage_;
  bool recording_ = false;
  std::size_t published_ = 0;
  std::string refused_;
  ros::Time told_;
  ros::Publisher scan_;
  ros::Publisher info_;
  ros::Publisher live_;
  ros::Publisher acknowledged_;
  ros::Publisher recording_told_;
  ros::ServiceServer start_;
  ros::ServiceServer stop_;
  ros::ServiceServer finish_;
  ros::Subscriber transforms_;
  ros::Subscriber static_transforms_;
  ros::Subscriber samples_;
  ros::WallTimer live_timer_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::ScanAccumulator, nodelet::Nodelet)
