// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/stage_results.h"

#include <pcl_ros/point_cloud.h>

#include <chrono>
#include <stdexcept>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;

constexpr auto look = std::chrono::milliseconds(50);  // at the cancel flag, while nothing comes

}  // namespace

template <class Message>
void StageResults::hold(ros::NodeHandle& nodes, const std::string& topic, boost::shared_ptr<const Message>& held) {
  subscribers_.push_back(nodes.subscribe<Message>(topic, 1, [this, &held](const boost::shared_ptr<const Message>& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    held = message;
    heard_ = ros::WallTime::now();
    changed_.notify_all();
  }));
}

StageResults::StageResults(const ros::NodeHandle& nodes, double silence) : silence_(silence) {
  ros::NodeHandle own(nodes);
  own.setCallbackQueue(&queue_);
  hold(own, "scan_cloud", cloud_);
  hold(own, "scan_info", scan_info_);
  hold(own, "fitted_scan", fitted_scan_);
  hold(own, "planned_path", planned_path_);
  hold(own, "motion_plan", motion_plan_);
  subscribers_.push_back(own.subscribe<core::StageReport>("stage_reports", 10, [this](const core::StageReportConstPtr& report) {
    const std::lock_guard<std::mutex> lock(mutex_);
    failures_[report->name] = *report;
    changed_.notify_all();
  }));
  subscribers_.push_back(own.subscribe<core::StageProgress>("stage_progress", 100, [this](const core::StageProgressConstPtr& at) {
    const std::lock_guard<std::mutex> lock(mutex_);
    fractions_[at->stage] = at->fraction;
    heard_ = ros::WallTime::now();
    changed_.notify_all();
  }));
  subscribers_.push_back(own.subscribe<std_msgs::Header>("scan_acknowledged", 10, [this](const std_msgs::HeaderConstPtr& at) {
    const std::lock_guard<std::mutex> lock(mutex_);
    acknowledged_ = at->stamp;
    acknowledged_at_ = ros::WallTime::now();
    changed_.notify_all();
  }));
  subscribers_.push_back(own.subscribe<std_msgs::Header>("scan_finished", 1, [this](const std_msgs::HeaderConstPtr& at) {
    const std::lock_guard<std::mutex> lock(mutex_);
    finished_ = at->stamp;
    changed_.notify_all();
  }));
  spinner_.start();
}

void StageResults::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  cloud_.reset();
  scan_info_.reset();
  fitted_scan_.reset();
  planned_path_.reset();
  motion_plan_.reset();
  failures_.clear();
  fractions_.clear();
  acknowledged_ = finished_ = ros::Time();
  heard_ = ros::WallTime::now();
}

void StageResults::throwFailure(const core::StageReport& report) const {
  if (report.exit == 130) throw core::Interrupted();
  if (report.exit == 2) throw core::InputError(report.error);
  throw std::runtime_error(report.name + ": " + report.error);
}

template <class Message>
boost::shared_ptr<const Message> StageResults::waitFor(const char* stage, boost::shared_ptr<const Message>& held,
                                                       const core::Progress& progress) {
  std::unique_lock<std::mutex> lock(mutex_);
  heard_ = ros::WallTime::now();
  while (!held) {
    const auto failure = failures_.find(stage);
    if (failure != failures_.end()) throwFailure(failure->second);
    if ((ros::WallTime::now() - heard_).toSec() > silence_) {
      throw core::InputError(std::string(stage) + ": nothing heard of this stage for " + core::fixed(silence_, 0) +
                             " s; is its nodelet running?");
    }
    const double fraction = fractions_[stage];
    lock.unlock();
    progress.update(stage, fraction);
    lock.lock();
    changed_.wait_for(lock, look);
  }
  return held;
}

boost::shared_ptr<const StageResults::Cloud> StageResults::cloud(const core::Progress& progress) {
  return waitFor("scan", cloud_, progress);
}

core::ScanInfoConstPtr StageResults::scanInfo(const core::Progress& progress) {
  return waitFor("scan", scan_info_, progress);
}

core::FittedScanConstPtr StageResults::fittedScan(const core::Progress& progress) {
  return waitFor("fit", fitted_scan_, progress);
}

core::PlannedPathConstPtr StageResults::plannedPath(const core::Progress& progress) {
  return waitFor("path", planned_path_, progress);
}

core::MotionPlanConstPtr StageResults::motionPlan(const core::Progress& progress) {
  return waitFor("motion", motion_plan_, progress);
}

void StageResults::waitForScan(const core::Progress& progress, double first_sample, double silence) {
  std::unique_lock<std::mutex> lock(mutex_);
  const ros::WallTime begin = ros::WallTime::now();
  for (;;) {
    const ros::WallTime now = ros::WallTime::now();
    if (!finished_.isZero() && acknowledged_ >= finished_) return;
    if (acknowledged_.isZero() && (now - begin).toSec() > first_sample) {
      throw core::InputError("scan: no sample came within " + core::fixed(first_sample, 0) + " s");
    }
    if (!acknowledged_.isZero() && (now - acknowledged_at_).toSec() > silence) return;
    lock.unlock();
    progress.update("scan", 0.0);
    lock.lock();
    changed_.wait_for(lock, look);
  }
}

}  // namespace scan_to_path_ros
