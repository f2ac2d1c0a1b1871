// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <actionlib/server/action_server.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <nodelet/nodelet.h>
#include <scan_to_path/RunJobAction.h>
#include <std_msgs/Empty.h>
#include <pluginlib/class_list_macros.hpp>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path_ros/nodelet_runner.h"
#include "scan_to_path_ros/parameters.h"

namespace scan_to_path_nodelets {

/// Runs jobs, one at a time, through the cell's nodelets and writes their files, as the command line would.
class JobServer : public nodelet::Nodelet {
  using Server = actionlib::ActionServer<scan_to_path::RunJobAction>;
  using Goal = Server::GoalHandle;

public:
  ~JobServer() override {
    going_down_ = true;
    cancelled_ = true;
    if (worker_.joinable()) worker_.join();
  }

private:
  void onInit() override {
    ros::NodeHandle& own = getPrivateNodeHandle();
    waiting_.first_sample = scan_to_path_ros::parameter(own, "first_sample", waiting_.first_sample);
    waiting_.silence = scan_to_path_ros::parameter(own, "silence", waiting_.silence);
    const double stage_silence = scan_to_path_ros::parameter(own, "stage_silence", 60.0);
    results_ = std::make_unique<scan_to_path_ros::StageResults>(getNodeHandle(), stage_silence);
    review_ = std::make_unique<scan_to_path_ros::Review>(own);
    cancel_ = getNodeHandle().advertise<std_msgs::Empty>("cancel", 1);
    server_ = std::make_unique<Server>(
        own, "run", [this](Goal goal) { accept(goal); }, [this](Goal goal) { cancel(goal); }, false);
    diagnostics_ = std::make_unique<diagnostic_updater::Updater>(getNodeHandle(), own, getName());
    diagnostics_->setHardwareID("none");
    diagnostics_->add("last job", this, &JobServer::diagnose);
    diagnostics_timer_ = getNodeHandle().createWallTimer(
        ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { diagnostics_->force_update(); });
    server_->start();
  }

  void accept(Goal goal) {
    scan_to_path::RunJobResult result;
    if (busy_.exchange(true)) {
      result.exit = 2;
      result.summary = {"a job is running; one at a time"};
      goal.setRejected(result, result.summary.front());
      return;
    }
    if (worker_.joinable()) worker_.join();
    cancelled_ = false;
    goal.setAccepted();
    note(result, true);
    worker_ = std::thread([this, goal]() mutable { run(goal); });
  }

  void cancel(const Goal&) {
    cancelled_ = true;
    cancel_.publish(std_msgs::Empty());
  }

  void run(Goal& goal) {
    scan_to_path::RunJobResult result;
    result.out = goal.getGoal()->out;
    try {
      scan_to_path_ros::setJob(getNodeHandle(), goal.getGoal()->configuration, goal.getGoal()->bag);
      const auto done = plan(*goal.getGoal(), progressOf(goal));
      result.exit = done.exit;
      result.summary = done.summary;
    } catch (const scan_to_path::InputError& error) {
      result.exit = 2;
      result.summary = {error.what()};
    } catch (const scan_to_path::Rejected& rejected) {
      result.exit = 130;
      result.summary = {rejected.what()};
    } catch (const scan_to_path::Interrupted&) {
      result.exit = going_down_ ? 2 : 130;
      result.summary = {going_down_ ? "the job server is gone" : "cancelled"};
      cancel_.publish(std_msgs::Empty());
    } catch (const std::exception& error) {
      result.exit = 3;
      result.summary = {error.what()};
    }
    scan_to_path_ros::clearJob(getNodeHandle());
    const std::string text = result.summary.empty() ? "" : result.summary.front();
    note(result, false);
    busy_ = false;  // who hears the result may send the next goal at once
    if (result.exit == 130)
      goal.setCanceled(result, text);
    else if (result.exit > 1)
      goal.setAborted(result, text);
    else
      goal.setSucceeded(result, text);
  }

  void note(const scan_to_path::RunJobResult& result, bool is_working) {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_ = result;
    is_working_ = is_working;
    jobs_ += is_working ? 1 : 0;
  }

  /// A job that wrote its result is no fault of the cell's, whatever it found.
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
    using diagnostic_msgs::DiagnosticStatus;
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool failed = last_.exit == 2 || last_.exit == 3;
    status.summary(failed ? DiagnosticStatus::ERROR : DiagnosticStatus::OK, is_working_ ? "working"
                                                                            : last_.summary.empty()
                                                                                ? "waiting"
                                                                                : last_.summary.front());
    status.add("jobs", jobs_);
    status.add("exit of the last job", last_.exit);
  }

  scan_to_path::pipeline::JobResult plan(const scan_to_path::RunJobGoal& goal, const scan_to_path::Progress& progress) {
    const auto options = scan_to_path_ros::readJobOptions(getNodeHandle());
    scan_to_path::pipeline::validateJob(options);
    scan_to_path::pipeline::JobRequest request;
    request.process = goal.process;
    request.out = goal.out;
    request.input = request.out / "scan.pcd";  // where NodeletRunner keeps it
    request.threads = scan_to_path_ros::parameter(getPrivateNodeHandle(), "threads", 0);
    request.package_path = scan_to_path_ros::packagePath();
    const auto cell = scan_to_path::pipeline::makeCell(options.cell, request.package_path);
    scan_to_path_ros::NodeletRunner stages(getNodeHandle(), *results_, waiting_, request, options, cell);
    if (goal.review != 0) stages.setReview(review_.get());
    auto done = scan_to_path::pipeline::runJob(request, options, cell, stages, progress);
    if (const auto delay = stages.pathDelay()) {
      done.summary.push_back("timing    path ready " + scan_to_path::fixed(*delay, 3) + " s after the last sample");
    }
    return done;
  }

  scan_to_path::Progress progressOf(Goal& goal) {
    return scan_to_path::Progress(
        [&goal](const std::string& stage, double fraction) {
          scan_to_path::RunJobFeedback feedback;
          feedback.stage = stage;
          feedback.fraction = fraction;
          goal.publishFeedback(feedback);
        },
        &cancelled_);
  }

  scan_to_path_ros::ScanWaiting waiting_;
  std::unique_ptr<scan_to_path_ros::StageResults> results_;
  std::unique_ptr<scan_to_path_ros::Review> review_;
  ros::Publisher cancel_;
  std::unique_ptr<Server> server_;
  std::mutex mutex_;
  scan_to_path::RunJobResult last_;
  bool is_working_ = false;
  std::size_t jobs_ = 0;
  std::unique_ptr<diagnostic_updater::Updater> diagnostics_;
  ros::WallTimer diagnostics_timer_;
  std::atomic<bool> busy_{false};
  std::atomic<bool> cancelled_{false};
  std::atomic<bool> going_down_{false};  ///< which cancels the job, and nobody asked for that
  std::thread worker_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::JobServer, nodelet::Nodelet)
