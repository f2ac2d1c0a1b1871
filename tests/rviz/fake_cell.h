// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <actionlib/server/action_server.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/spinner.h>
#include <scan_to_path/RunJobAction.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

/// What the panel talks to, each on a thread of its own as in a cell.
namespace scan_to_path_rviz::test {

inline constexpr double patience = 10.0;  // [s] for what takes milliseconds on a quiet machine

/// A job server that does what the test says, beside the thread of the windows as a real one is.
class FakeServer {
  using Server = actionlib::ActionServer<scan_to_path::RunJobAction>;

public:
  explicit FakeServer(const std::string& name) : nodes_(name) {
    nodes_.setCallbackQueue(&queue_);
    server_ = std::make_unique<Server>(
        nodes_, "run", [this](Server::GoalHandle goal) { take(goal); },
        [this](Server::GoalHandle) { cancelled_ = true; }, false);
    server_->start();
    spinner_.start();
  }
  ~FakeServer() { spinner_.stop(); }

  bool hasGoal() const { return has_goal_; }
  bool cancelled() const { return cancelled_; }
  std::shared_ptr<const scan_to_path::RunJobGoal> goal() const {
    return std::make_shared<const scan_to_path::RunJobGoal>(*goal_.getGoal());
  }
  void tell(const std::string& stage, double fraction) {
    scan_to_path::RunJobFeedback feedback;
    feedback.stage = stage;
    feedback.fraction = fraction;
    goal_.publishFeedback(feedback);
  }
  void end(int exit, const std::vector<std::string>& summary) {
    has_goal_ = false;
    scan_to_path::RunJobResult result;
    result.exit = exit;
    result.summary = summary;
    result.out = goal_.getGoal()->out;
    if (exit == 130)
      goal_.setCanceled(result, summary.front());
    else if (exit > 1)
      goal_.setAborted(result, summary.front());
    else
      goal_.setSucceeded(result, summary.front());
  }

  bool reject = false;

private:
  void take(Server::GoalHandle goal) {
    if (reject) {
      scan_to_path::RunJobResult result;
      result.exit = 2;
      result.summary = {"a job is running; one at a time"};
      goal.setRejected(result, result.summary.front());
      return;
    }
    goal.setAccepted();
    goal_ = goal;
    has_goal_ = true;
  }

  ros::NodeHandle nodes_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  std::unique_ptr<Server> server_;
  Server::GoalHandle goal_;
  std::atomic<bool> has_goal_{false};
  std::atomic<bool> cancelled_{false};
};

/// Takes the answer to a review.
class FakeReviewer {
  using Request = std_srvs::SetBool::Request;
  using Response = std_srvs::SetBool::Response;

public:
  FakeReviewer() {
    nodes_.setCallbackQueue(&queue_);
    service_ =
        nodes_.advertiseService<Request, Response>("job_server/accept", [this](Request& request, Response& response) {
          answer_ = request.data != 0 ? 1 : 0;
          response.success = 1;
          return true;
        });
    spinner_.start();
  }
  ~FakeReviewer() { spinner_.stop(); }

  /// 1: accepted; 0: rejected; -1: nobody answered.
  int answer() const { return answer_; }

private:
  std::atomic<int> answer_{-1};
  ros::NodeHandle nodes_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  ros::ServiceServer service_;
};

/// A player that takes its time, beside the thread of the windows.
class FakePlayer {
  using Request = std_srvs::Trigger::Request;
  using Response = std_srvs::Trigger::Response;

public:
  explicit FakePlayer(const std::string& why_not = "") : why_not_(why_not) {
    nodes_.setCallbackQueue(&queue_);
    active_ = nodes_.advertise<std_msgs::Bool>("playback_active", 1, true);
    tell(false);
    start_ =
        nodes_.advertiseService<Request, Response>("trajectory_player/start", [this](Request&, Response& response) {
          std::unique_lock<std::mutex> lock(mutex_);
          called_ = true;
          changed_.wait_for(lock, std::chrono::duration<double>(patience), [&] { return released_; });
          response.success = static_cast<std::uint8_t>(why_not_.empty());
          response.message = why_not_;
          if (why_not_.empty()) tell(true);
          return true;
        });
    stop_ = nodes_.advertiseService<Request, Response>("trajectory_player/stop", [this](Request&, Response& response) {
      response.success = 1;
      tell(false);
      return true;
    });
    spinner_.start();
  }
  ~FakePlayer() { spinner_.stop(); }

  bool called() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return called_;
  }
  void release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }

private:
  void tell(bool active) {
    std_msgs::Bool msg;
    msg.data = static_cast<std::uint8_t>(active);
    active_.publish(msg);
  }

  std::string why_not_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool called_ = false;
  bool released_ = false;
  ros::NodeHandle nodes_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  ros::Publisher active_;
  ros::ServiceServer start_;
  ros::ServiceServer stop_;
};

}  // namespace scan_to_path_rviz::test
