// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/SetBool.h>

#include <condition_variable>
#include <mutex>
#include <optional>

#include "scan_to_path/common/progress.h"

namespace scan_to_path_ros {

/// Asks whether what a job planned is wanted: the service `accept` takes the answer, true or false, while a job waits
/// for it and refuses it otherwise.
class Review {
public:
  /// `own`: the nodes that the service is named after.
  explicit Review(ros::NodeHandle own);

  /// The answer; waits for it as long as it takes, with the stage "review" as progress. Throws Interrupted.
  bool wait(const scan_to_path::Progress& progress);

private:
  bool answer(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  std::mutex mutex_;
  std::condition_variable answered_;
  bool waiting_ = false;
  std::optional<bool> answer_;
  ros::ServiceServer service_;
};

}  // namespace scan_to_path_ros
