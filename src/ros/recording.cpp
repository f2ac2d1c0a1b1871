// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/recording.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <scan_to_path/ScanSamples.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;
using core::InputError;

constexpr std::int64_t second = 1000000000;
constexpr std::int64_t margin = second;     // of joint states before the first sample and after the last one
constexpr std::int64_t pause = 2 * second;  // without samples: another scan, as the job server sees it

/// A log's time, to the microsecond that logs have.
std::int64_t nanoseconds(double seconds) { return 1000 * static_cast<std::int64_t>(std::llround(seconds * 1e6)); }

/// REP 117: NaN for a fault, -Inf for something too near, +Inf for no return.
double rangeOf(const core::sensing::PointLaserOptions& laser, double voltage) {
  if (std::isnan(voltage)) return std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double no_return = core::sensing::isTooNear(laser, voltage) ? -infinity : infinity;
  return core::sensing::distanceFromVoltage(laser, voltage).value_or(no_return);
}

std::int64_t stampOf(const ros::Time& stamp) { return static_cast<std::int64_t>(stamp.toNSec()); }

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

class BagReader {
public:
  BagReader(const std::filesystem::path& file, std::string sensor_frame)
      : name_(file.string()), sensor_frame_(std::move(sensor_frame)) {}

  Recording read() {
    try {
      const rosbag::Bag bag(name_, rosbag::bagmode::Read);
      rosbag::View view(bag, [](const rosbag::ConnectionInfo* at) { return isWanted(*at); });
      checkConnections(view);
      for (const auto& message : view) add(message);
    } catch (const rosbag::BagException& error) {
      fail(std::string("not a whole bag: ") + error.what());
    } catch (const ros::serialization::StreamOverrunException&) {
      fail("not a whole bag: a message is cut short");
    }
    check();
    trim();
    return std::move(recording_);
  }

private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_ + ": " + what); }

  static bool isWanted(const rosbag::ConnectionInfo& at) {
    return (endsWith("/" + at.topic, "/joint_states") && at.datatype == "sensor_msgs/JointState") ||
           (endsWith("/" + at.topic, "/scan_samples") && at.datatype == "scan_to_path/ScanSamples");
  }

  void checkConnections(rosbag::View& view) const {
    std::set<std::string> topics;
    for (const auto* at : view.getConnections()) topics.insert(at->topic);
    for (const std::string kind : {"joint_states", "scan_samples"}) {
      const auto count = std::count_if(topics.begin(), topics.end(),
                                       [&](const std::string& topic) { return endsWith("/" + topic, "/" + kind); });
      if (count == 0) fail("has no " + kind);
      if (count > 1) fail("has " + kind + " of " + std::to_string(count) + " cells, must be of one");
    }
  }

  void add(const rosbag::MessageInstance& message) {
    if (const auto joints = message.instantiate<sensor_msgs::JointState>())
      addJoints(*joints);
    else if (const auto samples = message.instantiate<core::ScanSamples>())
      addSamples(*samples);
    else
      fail("messages on " + message.getTopic() + " are of another version of " + message.getDataType());
  }

  void addJoints(const sensor_msgs::JointState& msg) {
    if (recording_.joint_names.empty()) recording_.joint_names = msg.name;
    const std::string at = "joint state " + std::to_string(recording_.joint_time.size());
    if (msg.name != recording_.joint_names || msg.position.size() != msg.name.size())
      fail(at + " is of other joints than the first");
    const std::int64_t time = stampOf(msg.header.stamp);
    if (!recording_.joint_time.empty() && time <= recording_.joint_time.back())
      fail(at + " is not later than the one before");
    const Eigen::Map<const Eigen::VectorXd> angles(msg.position.data(), static_cast<Eigen::Index>(msg.position.size()));
    if (angles.size() > 8) fail(at + " has " + std::to_string(angles.size()) + " joints, must be 8 at most");
    if (!angles.allFinite()) fail(at + " is not finite");
    recording_.joint_time.push_back(time);
    recording_.angles.emplace_back(angles);
  }

  void addSamples(const core::ScanSamples& msg) {
    const std::string at = "after sample " + std::to_string(recording_.range.size());
    if (msg.header.frame_id != sensor_frame_)
      fail(at + " the frame is '" + msg.header.frame_id + "', must be '" + sensor_frame_ + "'");
    if (msg.range.size() != msg.time_offset.size()) fail(at + " times and ranges are not as many");
    for (std::size_t i = 0; i < msg.range.size(); ++i) {
      if (!(std::isfinite(msg.time_offset[i]) && std::abs(msg.time_offset[i]) < 1e6))
        fail(at + " a time is not finite");
      const std::int64_t time = stampOf(msg.header.stamp + ros::Duration(msg.time_offset[i]));
      if (!recording_.sensor_time.empty()) {
        if (time <= recording_.sensor_time.back()) fail(at + " one is not later than the one before");
        if (time - recording_.sensor_time.back() > pause) {
          fail(at + " nothing comes for " +
               core::fixed(1e-9 * static_cast<double>(time - recording_.sensor_time.back()), 1) +
               " s: several scans, or messages were lost; a bag must hold one whole scan");
        }
      }
      recording_.sensor_time.push_back(time);
      recording_.range.push_back(msg.range[i]);
    }
  }

  void check() const {
    if (recording_.sensor_time.empty()) fail("has no samples");
    if (recording_.joint_time.empty()) fail("has no joint states");
  }

  /// Leaves out where the robot stood before and after the scan, and lets times start at 0.
  void trim() {
    auto& times = recording_.joint_time;
    const auto first =
        std::lower_bound(times.begin(), times.end(), recording_.sensor_time.front() - margin) - times.begin();
    const auto last =
        std::upper_bound(times.begin(), times.end(), recording_.sensor_time.back() + margin) - times.begin();
    if (first >= last) fail("joint states and samples do not overlap in time");
    times = std::vector<std::int64_t>(times.begin() + first, times.begin() + last);
    recording_.angles = {recording_.angles.begin() + first, recording_.angles.begin() + last};
    const std::int64_t begin = std::min(times.front(), recording_.sensor_time.front());
    for (auto& time : times) time -= begin;
    for (auto& time : recording_.sensor_time) time -= begin;
  }

  std::string name_;
  std::string sensor_frame_;
  Recording recording_;
};

}  // namespace

Recording recordingFromLog(const core::scan::SampleLog& log, const core::pipeline::Cell& cell) {
  Recording recording;
  recording.joint_names = log.joint_names;
  const std::size_t joints = log.joint_names.size();
  std::vector<double> counts(log.counts.begin(), log.counts.begin() + static_cast<std::ptrdiff_t>(joints));
  for (std::size_t i = 0; i < log.joint_time.size(); ++i) {
    for (std::size_t k = 0; k < joints; ++k)
      counts[k] = core::robot::unwrapCount(counts[k], log.counts[i * joints + k]);
    recording.joint_time.push_back(nanoseconds(log.joint_time[i]));
    recording.angles.push_back(cell.encoders.angles(counts.data()));
  }
  for (const double time : log.sensor_time) recording.sensor_time.push_back(nanoseconds(time));
  for (const double voltage : log.voltage) recording.range.push_back(rangeOf(cell.laser, voltage));
  return recording;
}

Recording recordingFromBag(const std::filesystem::path& file, const std::string& sensor_frame) {
  return BagReader(file, sensor_frame).read();
}

}  // namespace scan_to_path_ros
