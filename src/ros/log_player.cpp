// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/log_player.h"

#include <rosgraph_msgs/Clock.h>
#include <scan_to_path/ScanSamples.h>
#include <scan_to_path/StageReport.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;

ros::Time after(const ros::Time& begin, std::int64_t nanoseconds) {
  return begin + ros::Duration().fromNSec(nanoseconds);
}

std::int64_t toNanoseconds(double seconds) { return std::llround(seconds * 1e9); }

constexpr double idle_step = 0.02;  // [s]

}  // namespace

LogPlayer::LogPlayer(const ros::NodeHandle& nodes, const LogPlayerOptions& options, const core::robot::Robot& robot)
    : options_(options) {
  for (const auto& joint : robot.joints) {
    pose_.name.push_back(joint.name);
    pose_.position.push_back(std::clamp(0.0, joint.lower, joint.upper));
  }
  ros::NodeHandle own(nodes);
  advertise(own);
  idle_ = own.createWallTimer(ros::WallDuration(idle_step), [this](const ros::WallTimerEvent&) { idle(); });
}

void LogPlayer::advertise(ros::NodeHandle& nodes) {
  joints_ = nodes.advertise<sensor_msgs::JointState>("joint_states", 20000);
  samples_ = nodes.advertise<core::ScanSamples>("scan_samples", 20000);
  finished_ = nodes.advertise<std_msgs::Header>("scan_finished", 1);
  reports_ = nodes.advertise<core::StageReport>("stage_reports", 10);
  shown_ = nodes.subscribe<std_msgs::Bool>("playback_active", 1, [this](const std_msgs::BoolConstPtr& active) {
    const std::lock_guard<std::mutex> lock(mutex_);
    playback_active_ = active->data != 0;
  });
  if (options_.real_time) return;
  clock_ = nodes.advertise<rosgraph_msgs::Clock>("/clock", 100);
  acknowledged_ =
      nodes.subscribe<std_msgs::Header>("scan_acknowledged", 100, [this](const std_msgs::HeaderConstPtr& header) {
        const std::lock_guard<std::mutex> lock(mutex_);
        taken_ = header->stamp;
        changed_.notify_all();
      });
}

void LogPlayer::idle() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (playing_) return;
  if (!options_.real_time) tick(now_ + ros::Duration(idle_step));
  if (playback_active_ || ros::WallTime::now() < idle_until_) return;
  idle_until_ = ros::WallTime::now() + ros::WallDuration(options_.idle_period);
  const auto message = boost::make_shared<sensor_msgs::JointState>(pose_);
  message->header.stamp = options_.real_time ? ros::Time::now() : now_;
  joints_.publish(message);
}

LogPlayer::~LogPlayer() { stop(); }

void LogPlayer::start(Recording recording) {
  if (playing_) throw core::InputError("the emulator scans already");
  if (thread_.joinable()) thread_.join();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = false;
    error_.clear();
    taken_ = ros::Time();
    playing_ = true;
  }
  thread_ = std::thread([this, played = std::move(recording)] {
    play(played);
    report();
    playing_ = false;
  });
}

void LogPlayer::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

std::string LogPlayer::error() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return error_;
}

void LogPlayer::fail(const std::string& error) {
  const std::lock_guard<std::mutex> lock(mutex_);
  error_ = error;
}

void LogPlayer::report() {
  core::StageReport message;
  message.error = error();
  if (message.error.empty()) return;
  message.name = "scan";
  message.exit = 2;
  reports_.publish(message);
  ROS_ERROR_STREAM(message.error);
}

bool LogPlayer::pause(double seconds) {
  std::unique_lock<std::mutex> lock(mutex_);
  return !changed_.wait_for(lock, std::chrono::duration<double>(std::max(0.0, seconds)), [this] { return stopping_; });
}

bool LogPlayer::waitForListeners() {
  const ros::WallTime limit = ros::WallTime::now() + ros::WallDuration(options_.timeout);
  while (joints_.getNumSubscribers() == 0 || samples_.getNumSubscribers() == 0) {
    if (!pause(0.01)) return false;
    if (ros::WallTime::now() < limit) continue;
    fail("scan: nobody listens to " + (joints_.getNumSubscribers() == 0 ? joints_.getTopic() : samples_.getTopic()));
    return false;
  }
  return true;
}

bool LogPlayer::waitUntilTaken(const ros::Time& stamp) {
  std::unique_lock<std::mutex> lock(mutex_);
  ros::Time last = taken_;
  while (!stopping_ && taken_ < stamp) {
    changed_.wait_for(lock, std::chrono::duration<double>(options_.timeout),
                      [&] { return stopping_ || taken_ != last; });
    if (taken_ == last && !stopping_) {
      error_ = "scan: no sample was placed for " + core::fixed(options_.timeout, 1) +
               " s; do transforms come, is the accumulator running?";
      return false;
    }
    last = taken_;
  }
  return !stopping_;
}

void LogPlayer::tick(const ros::Time& now) {
  now_ = now;
  rosgraph_msgs::Clock clock;
  clock.clock = now;
  clock_.publish(clock);
}

void LogPlayer::publishJoints(const Recording& recording, std::size_t reading, const ros::Time& begin) {
  const auto& angles = recording.angles[reading];
  const auto message = boost::make_shared<sensor_msgs::JointState>();
  message->header.stamp = after(begin, recording.joint_time[reading]);
  message->name = recording.joint_names;
  message->position.assign(angles.data(), angles.data() + angles.size());
  joints_.publish(message);
}

void LogPlayer::publishSamples(const Recording& recording, std::size_t first, std::size_t last,
                               const ros::Time& begin) {
  if (first == last) return;
  const auto message = boost::make_shared<core::ScanSamples>();
  message->header.frame_id = options_.sensor_frame;
  message->header.stamp = after(begin, recording.sensor_time[first]);
  for (std::size_t i = first; i < last; ++i) {
    message->time_offset.push_back((after(begin, recording.sensor_time[i]) - message->header.stamp).toSec());
    message->range.push_back(recording.range[i]);
  }
  samples_.publish(message);
}

void LogPlayer::play(const Recording& recording) {
  if (!waitForListeners()) return;
  const auto& joint_time = recording.joint_time;
  const auto& sensor_time = recording.sensor_time;
  const ros::Time begin = (options_.real_time ? ros::Time::now() : now_) + ros::Duration(options_.settle);
  const ros::WallTime wall = ros::WallTime::now() + ros::WallDuration(options_.settle);
  const std::int64_t end = std::max(joint_time.back(), sensor_time.back());
  const std::int64_t batch = toNanoseconds(options_.batch);
  std::size_t reading = 0;
  std::size_t sample = 0;
  for (std::int64_t until = batch; sample < sensor_time.size() || reading < joint_time.size(); until += batch) {
    if (options_.real_time && !pause(1e-9 * static_cast<double>(until) - (ros::WallTime::now() - wall).toSec())) return;
    for (; reading < joint_time.size() && joint_time[reading] <= until; ++reading)
      publishJoints(recording, reading, begin);
    const std::size_t first = sample;
    while (sample < sensor_time.size() && sensor_time[sample] <= until) ++sample;
    publishSamples(recording, first, sample, begin);
    if (options_.real_time) continue;
    tick(after(begin, std::min(until, end)));
    const auto needed = std::upper_bound(sensor_time.begin(), sensor_time.begin() + static_cast<std::ptrdiff_t>(sample),
                                         until - toNanoseconds(options_.window));
    if (needed != sensor_time.begin() && !waitUntilTaken(after(begin, *std::prev(needed)))) return;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto& angles = recording.angles.back();
    pose_.name = recording.joint_names;
    pose_.position.assign(angles.data(), angles.data() + angles.size());
    idle_until_ = ros::WallTime::now() + ros::WallDuration(options_.settle);
  }
  std_msgs::Header header;
  header.stamp = after(begin, sensor_time.back());
  finished_.publish(header);
}

}  // namespace scan_to_path_ros
