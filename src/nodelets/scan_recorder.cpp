// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <nodelet/nodelet.h>
#include <rosbag/bag.h>
#include <scan_to_path/ScanSamples.h>
#include <scan_to_path/StageReport.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>
#include <pluginlib/class_list_macros.hpp>

#include "scan_to_path_ros/parameters.h"

namespace scan_to_path_nodelets {

/// Records what the robot and its sensor say, from its loading until stopped or unloaded, into a bag that `run_job
/// --bag` replays. In the cell's manager nothing is lost, however fast it comes; `rosbag record` drops what it cannot
/// take. A job whose scan cannot be recorded fails.
class ScanRecorder : public nodelet::Nodelet {
public:
  ~ScanRecorder() override { close(); }

private:
  void onInit() override {
    file_ = scan_to_path_ros::parameter<std::string>(getPrivateNodeHandle(), "file", "");
    reports_ = getNodeHandle().advertise<scan_to_path::StageReport>("stage_reports", 10);
    stop_ = getPrivateNodeHandle().advertiseService("stop", &ScanRecorder::stop, this);
    scan_ = getNodeHandle().subscribe("scan_recording", 1, &ScanRecorder::noteScan, this);
    try {
      bag_.open(file_, rosbag::bagmode::Write);
      bag_.setCompression(rosbag::compression::LZ4);
    } catch (const rosbag::BagException& error) {
      return fail(error.what());
    }
    record<sensor_msgs::JointState>("joint_states", "joint_states");
    record<scan_to_path::ScanSamples>("scan_samples", "scan_samples");
    record<tf2_msgs::TFMessage>("/tf_static", "tf_static");
    if (scan_to_path_ros::parameter(getPrivateNodeHandle(), "tf", false)) record<tf2_msgs::TFMessage>("/tf", "tf");
  }

  void fail(const std::string& why) {
    for (auto& subscriber : subscribers_) subscriber.shutdown();
    error_ = "scan: cannot record into " + file_ + ": " + why;
    NODELET_ERROR("%s", error_.c_str());
    if (is_scanning_) report();
  }

  void report() {
    scan_to_path::StageReport message;
    message.name = "scan";
    message.exit = 2;
    message.error = error_;
    reports_.publish(message);
  }

  void noteScan(const std_msgs::BoolConstPtr& msg) {
    is_scanning_ = msg->data != 0;
    if (is_scanning_ && !error_.empty()) report();
  }

  bool stop(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const bool was_open = bag_.isOpen();
    close();
    response.success = static_cast<std::uint8_t>(was_open && error_.empty());
    response.message = !error_.empty() ? error_ : was_open ? file_ : "nothing is recorded any more";
    return true;
  }

  void close() {
    for (auto& subscriber : subscribers_) subscriber.shutdown();
    try {
      if (bag_.isOpen()) bag_.close();
    } catch (const rosbag::BagException& error) {
      fail(error.what());
    }
  }

  /// The queue has no end; one queue keeps the order.
  template <class Message>
  void record(const std::string& topic, const std::string& name) {
    const std::string resolved = getNodeHandle().resolveName(name);
    subscribers_.push_back(getNodeHandle().subscribe<Message>(
        topic, 0, [this, resolved](const boost::shared_ptr<const Message>& msg) { write(resolved, msg); }));
  }

  template <class Message>
  void write(const std::string& topic, const boost::shared_ptr<const Message>& msg) {
    try {
      bag_.write(topic, ros::Time::now().isZero() ? ros::TIME_MIN : ros::Time::now(), msg);
    } catch (const rosbag::BagException& error) {
      fail(error.what());
    }
  }

  std::string file_;
  std::string error_;  ///< why nothing is recorded; empty while all is well
  bool is_scanning_ = false;
  rosbag::Bag bag_;
  ros::Publisher reports_;
  ros::ServiceServer stop_;
  ros::Subscriber scan_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::ScanRecorder, nodelet::Nodelet)
