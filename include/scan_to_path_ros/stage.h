// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <std_msgs/Header.h>

#include <atomic>
#include <functional>
#include <string>

#include "scan_to_path/common/progress.h"

namespace scan_to_path_ros {

/// What every stage of a job does around its work: tells how far it is on `stage_progress`, ends at the next look when
/// a message comes on `cancel`, and says on `stage_reports` why it could not finish. One job at a time.
class Stage {
public:
  /// `name` as in StageReport. Messages on `cancel` are heard on a queue of their own: a stage at work blocks its
  /// nodelet's.
  Stage(const ros::NodeHandle& nodes, const std::string& name);

  /// Runs `work` for the job of `header`. What it throws becomes a report with the exit status the command line would
  /// have. Returns whether it came to its end.
  bool run(const std_msgs::Header& header, const std::function<void(const scan_to_path::Progress&)>& work);

  const std::string& name() const { return name_; }

private:
  std::string name_;
  std::atomic<bool> cancelled_{false};
  ros::Publisher progress_;
  ros::Publisher reports_;
  ros::CallbackQueue cancel_queue_;
  ros::Subscriber cancel_;
  ros::AsyncSpinner cancel_spinner_{1, &cancel_queue_};
};

}  // namespace scan_to_path_ros
