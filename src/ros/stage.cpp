// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/stage.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/console.h>
#include <scan_to_path/StageProgress.h>
#include <scan_to_path/StageReport.h>
#include <std_msgs/Empty.h>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;

/// The command line's exit statuses.
constexpr int bad_input = 2;
constexpr int bug = 3;
constexpr int interrupted = 130;

constexpr double diagnostic_period = 1.0;  // [s of wall time], as diagnostics tools expect

core::StageReport failure(const std_msgs::Header& header, const std::string& name, int exit, const std::string& error) {
  core::StageReport report;
  report.header = header;
  report.name = name;
  report.exit = exit;
  report.error = error;
  return report;
}

diagnostic_msgs::KeyValue value(const std::string& key, const std::string& text) {
  diagnostic_msgs::KeyValue entry;
  entry.key = key;
  entry.value = text;
  return entry;
}

}  // namespace

Stage::Stage(const ros::NodeHandle& nodes, const std::string& name) : name_(name), full_name_(nodes.resolveName(name)) {
  ros::NodeHandle own(nodes);
  own.setCallbackQueue(&queue_);
  progress_ = own.advertise<core::StageProgress>("stage_progress", 100);
  reports_ = own.advertise<core::StageReport>("stage_reports", 10);
  diagnostics_ = own.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100);
  cancel_ = own.subscribe<std_msgs::Empty>("cancel", 1, [this](const std_msgs::EmptyConstPtr&) { cancelled_ = true; });
  diagnostics_timer_ =
      own.createWallTimer(ros::WallDuration(diagnostic_period), [this](const ros::WallTimerEvent&) { diagnose(); });
  spinner_.start();
}

bool Stage::run(const std_msgs::Header& header, const std::function<void(const core::Progress&)>& work) {
  begin();
  std::string error;
  const int exit = attempt(header, work, error);
  end(exit, error);
  if (exit != 0) reports_.publish(failure(header, name_, exit, error));
  return exit == 0;
}

int Stage::attempt(const std_msgs::Header& header, const std::function<void(const core::Progress&)>& work,
                   std::string& error) {
  const core::Progress progress(
      [&](const std::string&, double fraction) {
        core::StageProgress message;
        message.header = header;
        message.stage = name_;
        message.fraction = fraction;
        progress_.publish(message);
      },
      &cancelled_);
  try {
    work(progress);
    return 0;
  } catch (const core::InputError& refused) {
    error = refused.what();
    ROS_ERROR_STREAM(name_ << ": " << error);
    return bad_input;
  } catch (const core::Interrupted&) {
    error = "cancelled";
    ROS_INFO_STREAM(name_ << ": cancelled");
    return interrupted;
  } catch (const std::exception& unexpected) {
    error = unexpected.what();
    ROS_FATAL_STREAM(name_ << ": " << error);
    return bug;
  }
}

void Stage::begin() {
  cancelled_ = false;
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.working = true;
  state_.begin = ros::WallTime::now();
}

void Stage::end(int exit, const std::string& error) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.working = false;
  state_.exit = exit;
  state_.error = error;
  ++state_.jobs;
  state_.seconds = (ros::WallTime::now() - state_.begin).toSec();
}

std::string Stage::error() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_.error;
}

void Stage::setDetails(const std::map<std::string, std::string>& details) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.details = details;
}

void Stage::diagnose() {
  using diagnostic_msgs::DiagnosticStatus;
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = ros::Time::now();
  DiagnosticStatus& status = message.status.emplace_back();
  status.name = full_name_;
  status.hardware_id = "none";
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool failed = !state_.working && state_.exit != 0 && state_.exit != interrupted;
  status.level = failed ? DiagnosticStatus::ERROR : DiagnosticStatus::OK;
  status.message = state_.working ? "working" : state_.error.empty() ? "waiting" : state_.error;
  status.values = {value("jobs", std::to_string(state_.jobs)),
                   value("exit of the last job", std::to_string(state_.exit)),
                   value("time of the last job [s]", core::fixed(state_.seconds, 3))};
  for (const auto& [key, text] : state_.details) status.values.push_back(value(key, text));
  diagnostics_.publish(message);
}

}  // namespace scan_to_path_ros
