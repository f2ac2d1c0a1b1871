// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/log_player.h"

#include <rosgraph_msgs/Clock.h>
#include <scan_to_path/ScanSamples.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "scan_to_path/common/error.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;

/// A log's time on top of a stamp, to the microsecond that logs have.
ros::Time after(const ros::Time& begin, double seconds) {
  return begin + ros::Duration().fromNSec(1000 * static_cast<std::int64_t>(std::llround(seconds * 1e6)));
}

constexpr double idle_step = 0.02;  // [s]

}  // namespace

/// A sample log in the units of messages.
struct LogPlayer::Log {
  std::vector<std::string> joint_names;
  std::vector<double> joint_time;
  std::vector<core::robot::JointVector> angles;
  std::vector<double> sensor_time;
  std::vector<double> range;

  Log(core::scan::SampleLog&& log, const core::pipeline::Cell& cell)
      : joint_names(log.joint_names), joint_time(std::move(log.joint_time)), sensor_time(std::move(log.sensor_time)) {
    const std::size_t joints = joint_names.size();
    std::vector<double> counts(log.counts.begin(), log.counts.begin() + static_cast<std::ptrdiff_t>(joints));
    angles.reserve(joint_time.size());
    for (std::size_t i = 0; i < joint_time.size(); ++i) {
      for (std::size_t k = 0; k < joints; ++k) counts[k] = core::robot::unwrapCount(counts[k], log.counts[i * joints + k]);
      angles.push_back(cell.encoders.angles(counts.data()));
    }
    range.reserve(log.voltage.size());
    for (const double voltage : log.voltage) range.push_back(rangeOf(cell.laser, voltage));
  }

  /// REP 117: NaN for a fault, +Inf for no return.
  static double rangeOf(const core::sensing::PointLaserOptions& laser, double voltage) {
    if (std::isnan(voltage)) return std::numeric_limits<double>::quiet_NaN();
    return core::sensing::distanceFromVoltage(laser, voltage).value_or(std::numeric_limits<double>::infinity());
  }
};

LogPlayer::LogPlayer(const ros::NodeHandle& nodes, const LogPlayerOptions& options) : options_(options) {
  ros::NodeHandle own(nodes);
  joints_ = own.advertise<sensor_msgs::JointState>("joint_states", 20000);
  samples_ = own.advertise<core::ScanSamples>("scan_samples", 20000);
  finished_ = own.advertise<std_msgs::Header>("scan_finished", 1);
  if (options_.real_time) return;
  clock_ = own.advertise<rosgraph_msgs::Clock>("/clock", 100);
  acknowledged_ = own.subscribe<std_msgs::Header>("scan_acknowledged", 100, [this](const std_msgs::HeaderConstPtr& header) {
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_ = header->stamp;
    changed_.notify_all();
  });
  idle_ = own.createWallTimer(ros::WallDuration(idle_step), [this](const ros::WallTimerEvent&) {
    if (!playing_) tick(now_ + ros::Duration(idle_step));
  });
}

LogPlayer::~LogPlayer() { stop(); }

void LogPlayer::start(core::scan::SampleLog log, const core::pipeline::Cell& cell) {
  if (playing_) throw core::InputError("the emulator scans already");
  if (thread_.joinable()) thread_.join();
  stopping_ = false;
  error_.clear();
  taken_ = ros::Time();
  playing_ = true;
  thread_ = std::thread([this, played = Log(std::move(log), cell)] {
    play(played);
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

bool LogPlayer::pause(double seconds) {
  std::unique_lock<std::mutex> lock(mutex_);
  return !changed_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return stopping_; });
}

bool LogPlayer::waitForListeners() {
  const ros::WallTime limit = ros::WallTime::now() + ros::WallDuration(options_.timeout);
  while (joints_.getNumSubscribers() == 0 || samples_.getNumSubscribers() == 0) {
    if (!pause(0.01)) return false;
    if (ros::WallTime::now() < limit) continue;
    fail("nobody listens to " + (joints_.getNumSubscribers() == 0 ? joints_.getTopic() : samples_.getTopic()));
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
      error_ = "no sample was taken for " + std::to_string(options_.timeout) + " s: transforms or accumulator missing";
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

void LogPlayer::publishJoints(const Log& log, std::size_t reading, const ros::Time& begin) {
  const auto message = boost::make_shared<sensor_msgs::JointState>();
  message->header.stamp = after(begin, log.joint_time[reading]);
  message->name = log.joint_names;
  message->position.assign(log.angles[reading].data(), log.angles[reading].data() + log.angles[reading].size());
  joints_.publish(message);
}

void LogPlayer::publishSamples(const Log& log, std::size_t first, std::size_t last, const ros::Time& begin) {
  if (first == last) return;
  const auto message = boost::make_shared<core::ScanSamples>();
  message->header.frame_id = options_.sensor_frame;
  message->header.stamp = after(begin, log.sensor_time[first]);
  for (std::size_t i = first; i < last; ++i) {
    message->time_offset.push_back((after(begin, log.sensor_time[i]) - message->header.stamp).toSec());
    message->range.push_back(log.range[i]);
  }
  samples_.publish(message);
}

void LogPlayer::play(const Log& log) {
  if (!waitForListeners()) return;
  const ros::Time begin = options_.real_time ? ros::Time::now() : now_;
  const ros::WallTime wall = ros::WallTime::now();
  const double end = std::max(log.joint_time.back(), log.sensor_time.back());
  std::size_t reading = 0;
  std::size_t sample = 0;
  for (double until = options_.batch; sample < log.sensor_time.size() || reading < log.joint_time.size();
       until += options_.batch) {
    for (; reading < log.joint_time.size() && log.joint_time[reading] <= until; ++reading) publishJoints(log, reading, begin);
    const std::size_t first = sample;
    while (sample < log.sensor_time.size() && log.sensor_time[sample] <= until) ++sample;
    publishSamples(log, first, sample, begin);
    if (options_.real_time) {
      if (!pause(std::max(0.0, until - (ros::WallTime::now() - wall).toSec()))) return;
      continue;
    }
    tick(after(begin, std::min(until, end)));
    const auto needed = std::upper_bound(log.sensor_time.begin(), log.sensor_time.begin() + static_cast<std::ptrdiff_t>(sample),
                                         until - options_.window);
    if (needed != log.sensor_time.begin() && !waitUntilTaken(after(begin, *std::prev(needed)))) return;
  }
  std_msgs::Header header;
  header.stamp = after(begin, log.sensor_time.back());
  finished_.publish(header);
}

}  // namespace scan_to_path_ros
