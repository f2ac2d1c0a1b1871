// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <nodelet/nodelet.h>
#include <rosbag/bag.h>
#include <scan_to_path/ScanSamples.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>
#include <pluginlib/class_list_macros.hpp>

#include "scan_to_path_ros/parameters.h"

namespace scan_to_path_nodelets {

/// Records what the robot and its sensor say, from its loading to its unloading, into a bag that `run_job --bag`
/// replays. In the cell's manager nothing is lost, however fast it comes; `rosbag record` drops what it cannot take.
class ScanRecorder : public nodelet::Nodelet {
public:
  ~ScanRecorder() override {
    for (auto& subscriber : subscribers_) subscriber.shutdown();
    try {
      if (bag_.isOpen()) bag_.close();
    } catch (const rosbag::BagException& error) {
      NODELET_ERROR("the recording is not whole: %s", error.what());
    }
  }

private:
  void onInit() override {
    const auto file = scan_to_path_ros::parameter<std::string>(getPrivateNodeHandle(), "file", "");
    bag_.open(file, rosbag::bagmode::Write);
    bag_.setCompression(rosbag::compression::LZ4);
    record<sensor_msgs::JointState>("joint_states", "joint_states");
    record<scan_to_path::ScanSamples>("scan_samples", "scan_samples");
    record<tf2_msgs::TFMessage>("/tf_static", "tf_static");
    if (scan_to_path_ros::parameter(getPrivateNodeHandle(), "tf", false)) record<tf2_msgs::TFMessage>("/tf", "tf");
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
      NODELET_ERROR("recording ends: %s", error.what());
      for (auto& subscriber : subscribers_) subscriber.shutdown();
    }
  }

  rosbag::Bag bag_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::ScanRecorder, nodelet::Nodelet)
