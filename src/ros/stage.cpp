// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/stage.h"

#include <ros/console.h>
#include <scan_to_path/StageProgress.h>
#include <scan_to_path/StageReport.h>
#include <std_msgs/Empty.h>

#include "scan_to_path/common/error.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;

/// The command line's exit statuses.
constexpr int bad_input = 2;
constexpr int bug = 3;
constexpr int interrupted = 130;

core::StageReport failure(const std_msgs::Header& header, const std::string& name, int exit, const std::string& error) {
  core::StageReport report;
  report.header = header;
  report.name = name;
  report.exit = exit;
  report.error = error;
  return report;
}

}  // namespace

Stage::Stage(const ros::NodeHandle& nodes, const std::string& name) : name_(name) {
  ros::NodeHandle own(nodes);
  progress_ = own.advertise<core::StageProgress>("stage_progress", 100);
  reports_ = own.advertise<core::StageReport>("stage_reports", 10);
  ros::NodeHandle cancelling(nodes);
  cancelling.setCallbackQueue(&cancel_queue_);
  cancel_ = cancelling.subscribe<std_msgs::Empty>("cancel", 1, [this](const std_msgs::EmptyConstPtr&) { cancelled_ = true; });
  cancel_spinner_.start();
}

bool Stage::run(const std_msgs::Header& header, const std::function<void(const core::Progress&)>& work) {
  cancelled_ = false;
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
    return true;
  } catch (const core::InputError& error) {
    ROS_ERROR_STREAM(name_ << ": " << error.what());
    reports_.publish(failure(header, name_, bad_input, error.what()));
  } catch (const core::Interrupted&) {
    ROS_INFO_STREAM(name_ << ": cancelled");
    reports_.publish(failure(header, name_, interrupted, "cancelled"));
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM(name_ << ": " << error.what());
    reports_.publish(failure(header, name_, bug, error.what()));
  }
  return false;
}

}  // namespace scan_to_path_ros
