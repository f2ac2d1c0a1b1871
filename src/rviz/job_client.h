// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <scan_to_path/RunJobAction.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace scan_to_path_rviz {

/// How a job ended.
struct JobEnd {
  int exit = 0;  ///< as the command line's exit status
  std::vector<std::string> summary;
  std::string out;
};

/// A client of the action that runs jobs. Nothing waits: what comes back comes on the queue of the node handle, for
/// rviz in the thread of its windows.
class JobClient {
public:
  struct Listener {
    std::function<void(const std::string& stage, double fraction)> progress;
    std::function<void(const JobEnd&)> ended;
  };

  /// `server` is a name relative to the node handle, e.g. "job_server".
  JobClient(const ros::NodeHandle& nodes, const std::string& server, Listener listener);

  bool connected() const { return client_->isServerConnected(); }
  bool running() const { return running_; }

  void run(const scan_to_path::RunJobGoal& goal);
  void cancel();

  /// To be called now and then: ends the job of a server that is gone.
  void look();

private:
  using Client = actionlib::SimpleActionClient<scan_to_path::RunJobAction>;

  void finish(const scan_to_path::RunJobResultConstPtr& result, const std::string& text);

  ros::NodeHandle nodes_;
  Listener listener_;
  std::unique_ptr<Client> client_;
  bool running_ = false;
};

}  // namespace scan_to_path_rviz
