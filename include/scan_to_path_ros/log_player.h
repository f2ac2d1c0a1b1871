// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Header.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "scan_to_path_ros/recording.h"

namespace scan_to_path_ros {

struct LogPlayerOptions {
  bool real_time = false;  ///< at the log's own pace on the wall's clock; else as fast as it is taken, on /clock
  double batch = 0.02;     ///< length of one message of samples [s]
  double window = 0.05;    ///< how far it runs ahead of scan_acknowledged when not in real time [s]
  double timeout = 10.0;   ///< without an acknowledgement, or a listener, after which it gives up [s of wall time]
  double settle = 0.5;  ///< from where the robot stood to the first stamp: more than scan.placement.max_joint_gap [s]
  double idle_period = 0.25;  ///< of the joint states while nothing is played [s]
  std::string sensor_frame = "sensor";
};

/// Plays a recording as a robot and its sensor would speak: joint_states and scan_samples, each with its own stamps.
/// Without real time it publishes /clock too, which goes on at the wall's pace while nothing is played, and waits for
/// scan_acknowledged, so that nobody's queue overflows. While nothing is played the robot stands where it was last;
/// it is silent while playback_active says that a trajectory is shown.
class LogPlayer {
public:
  /// The robot stands with its joints at 0, or where the limits are nearest to 0.
  LogPlayer(const ros::NodeHandle& nodes, const LogPlayerOptions& options, const scan_to_path::robot::Robot& robot);
  ~LogPlayer();

  /// Starts in a thread of its own; scan_finished (the last sample's stamp), or the error on stage_reports, ends it.
  /// Throws InputError when it plays already.
  void start(Recording recording);

  /// Ends playing; nothing more is published afterwards.
  void stop();

  bool isPlaying() const { return playing_; }

  /// Why the last log was not played to its end; empty when it was.
  std::string error() const;

private:
  void advertise(ros::NodeHandle& nodes);
  void play(const Recording& recording);
  bool waitForListeners();
  bool waitUntilTaken(const ros::Time& stamp);
  bool pause(double seconds);
  void publishJoints(const Recording& recording, std::size_t reading, const ros::Time& begin);
  void publishSamples(const Recording& recording, std::size_t first, std::size_t last, const ros::Time& begin);
  void fail(const std::string& error);
  /// Tells the job why the scan has no end, if it has none.
  void report();
  void tick(const ros::Time& now);
  void idle();

  LogPlayerOptions options_;
  ros::Publisher joints_;
  ros::Publisher samples_;
  ros::Publisher clock_;
  ros::Publisher finished_;
  ros::Publisher reports_;
  ros::Subscriber acknowledged_;
  ros::Subscriber shown_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  ros::Time taken_;
  std::string error_;
  bool stopping_ = false;
  std::atomic<bool> playing_{false};
  ros::Time now_{1.0};            ///< simulated; tf2 takes nothing at 0
  sensor_msgs::JointState pose_;  ///< the robot's last
  bool playback_active_ = false;
  ros::WallTime idle_until_;  ///< of the next joint state while idle
  ros::WallTimer idle_;
  std::thread thread_;
};

}  // namespace scan_to_path_ros
