// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <std_msgs/Header.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "scan_to_path/pipeline/cell.h"
#include "scan_to_path/scan/sample_log.h"

namespace scan_to_path_ros {

struct LogPlayerOptions {
  bool real_time = false;        ///< at the log's own pace on the wall's clock; else as fast as it is taken, on /clock
  double batch = 0.02;           ///< length of one message of samples [s]
  double window = 0.05;          ///< how far it runs ahead of scan_acknowledged when not in real time [s]
  double timeout = 10.0;         ///< without an acknowledgement, or a listener, after which it gives up [s of wall time]
  std::string sensor_frame = "sensor";
};

/// Plays a sample log as a robot and its sensor would speak: joint_states and scan_samples, each with its own stamps.
/// Without real time it publishes /clock too, which goes on at the wall's pace while nothing is played, and waits for
/// scan_acknowledged, so that nobody's queue overflows.
class LogPlayer {
public:
  LogPlayer(const ros::NodeHandle& nodes, const LogPlayerOptions& options);
  ~LogPlayer();

  /// Starts in a thread of its own; scan_finished (the last sample's stamp) or the error ends it. Throws InputError
  /// when it plays already.
  void start(scan_to_path::scan::SampleLog log, const scan_to_path::pipeline::Cell& cell);

  /// Ends playing; nothing more is published afterwards.
  void stop();

  bool isPlaying() const { return playing_; }

  /// Why the last log was not played to its end; empty when it was.
  std::string error() const;

private:
  struct Log;

  void play(const Log& log);
  bool waitForListeners();
  bool waitUntilTaken(const ros::Time& stamp);
  bool pause(double seconds);
  void publishJoints(const Log& log, std::size_t reading, const ros::Time& begin);
  void publishSamples(const Log& log, std::size_t first, std::size_t last, const ros::Time& begin);
  void fail(const std::string& error);
  void tick(const ros::Time& now);

  LogPlayerOptions options_;
  ros::Publisher joints_;
  ros::Publisher samples_;
  ros::Publisher clock_;
  ros::Publisher finished_;
  ros::Subscriber acknowledged_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  ros::Time taken_;
  std::string error_;
  bool stopping_ = false;
  std::atomic<bool> playing_{false};
  ros::Time now_{1.0};  ///< simulated; tf2 takes nothing at 0
  ros::WallTimer idle_;
  std::thread thread_;
};

}  // namespace scan_to_path_ros
