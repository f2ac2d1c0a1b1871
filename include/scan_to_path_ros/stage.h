// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <std_msgs/Header.h>

#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "scan_to_path/common/progress.h"

namespace scan_to_path_ros {

/// What every stage of a job does around its work: tells how far it is on `stage_progress`, ends at the next look when
/// a message comes on `cancel`, says on `stage_reports` why it could not finish, and in diagnostics what it does and
/// how the last job went. One job at a time.
class Stage {
public:
  /// `name` as in StageReport. Messages on `cancel` are heard, and diagnostics sent, on a queue of their own: a stage
  /// at work blocks its nodelet's.
  Stage(const ros::NodeHandle& nodes, const std::string& name);

  /// Runs `work` for the job of `header`. What it throws becomes a report with the exit status the command line would
  /// have. Returns whether it came to its end.
  bool run(const std_msgs::Header& header, const std::function<void(const scan_to_path::Progress&)>& work);

  const std::string& name() const { return name_; }

  /// Why the last run did not come to its end; empty when it did.
  std::string error() const;

  /// Numbers of the stage's own for its diagnostics, in the place of those given before.
  void setDetails(const std::map<std::string, std::string>& details);

private:
  /// What diagnostics say of a stage.
  struct State {
    bool working = false;
    int exit = 0;  ///< of the last run
    std::string error;
    std::size_t jobs = 0;
    ros::WallTime begin;
    double seconds = 0.0;  ///< of the last run
    std::map<std::string, std::string> details;
  };

  int attempt(const std_msgs::Header& header, const std::function<void(const scan_to_path::Progress&)>& work,
              std::string& error);
  void begin();
  void end(int exit, const std::string& error);
  void diagnose();

  std::string name_;
  std::string full_name_;  ///< with the cell's namespace
  std::atomic<bool> cancelled_{false};
  mutable std::mutex mutex_;
  State state_;
  ros::CallbackQueue queue_;  ///< outlives all that names it: publishers do as well, when they withdraw
  ros::Publisher progress_;
  ros::Publisher reports_;
  ros::Publisher diagnostics_;
  ros::WallTimer diagnostics_timer_;
  ros::Subscriber cancel_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace scan_to_path_ros
