// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/stage_results.h"

#include <pcl_conversions/pcl_conversions.h>
#include <pcl_ros/point_cloud.h>

#include <chrono>
#include <stdexcept>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;

constexpr auto look = std::chrono::milliseconds(50);  // at the cancel flag, while nothing comes

template <class Message>
ros::Time stampOf(const Message& message) {
  return message.header.stamp;
}

ros::Time stampOf(const StageResults::Cloud& cloud) { return pcl_conversions::fromPCL(cloud.header.stamp); }

}  // namespace

template <class Message>
void StageResults::hold(ros::NodeHandle& nodes, const std::string& topic, boost::shared_ptr<const Message>& held) {
  subscribers_.push_back(
      nodes.subscribe<Message>(topic, 1, [this, &held](const boost::shared_ptr<const Message>& message) {
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
  subscribers_.push_back(
      own.subscribe<core::StageReport>("stage_reports", 10, [this](const core::StageReportConstPtr& report) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!isOfThisJob(report->header.stamp)) return;
        failures_[report->name] = *report;
        changed_.notify_all();
      }));
  subscribers_.push_back(
      own.subscribe<core::StageProgress>("stage_progress", 100, [this](const core::StageProgressConstPtr& at) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!isOfThisJob(at->header.stamp)) return;
        fractions_[at->stage] = at->fraction;
        heard_ = ros::WallTime::now();
        changed_.notify_all();
      }));
  subscribers_.push_back(
      own.subscribe<std_msgs::Header>("scan_acknowledged", 10, [this](const std_msgs::HeaderConstPtr& at) {
        const std::lock_guard<std::mutex> lock(mutex_);
        acknowledged_ = at->stamp;
        acknowledged_at_ = ros::WallTime::now();
        changed_.notify_all();
      }));
  subscribers_.push_back(
      own.subscribe<std_msgs::Header>("scan_finished", 1, [this](const std_msgs::HeaderConstPtr& at) {
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
  acknowledged_ = finished_ = job_ = ros::Time();
  heard_ = ros::WallTime::now();
}

void StageResults::throwFailure(const std::string& stage) const {
  const auto failure = failures_.find(stage);
  if (failure == failures_.end()) return;
  const core::StageReport& report = failure->second;
  if (report.exit == 130) throw core::Interrupted();
  if (report.exit == 2) throw core::InputError(report.error);
  throw std::runtime_error(report.name + ": " + report.error);
}

template <class Message>
boost::shared_ptr<const Message> StageResults::waitFor(const char* stage, boost::shared_ptr<const Message>& held,
                                                       const core::Progress& progress) {
  std::unique_lock<std::mutex> lock(mutex_);
  heard_ = ros::WallTime::now();
  for (;;) {
    if (held && isOfThisJob(stampOf(*held))) return held;
    throwFailure(stage);
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
}

core::ScanInfoConstPtr StageResults::scanInfo(const core::Progress& progress) {
  const auto info = waitFor("scan", scan_info_, progress);
  const std::lock_guard<std::mutex> lock(mutex_);
  job_ = info->header.stamp;
  return info;
}

boost::shared_ptr<const StageResults::Cloud> StageResults::cloud(const core::Progress& progress) {
  return waitFor("scan", cloud_, progress);
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

void StageResults::waitForScan(const core::Progress& progress, const ScanWaiting& waiting) {
  std::unique_lock<std::mutex> lock(mutex_);
  const ros::WallTime begin = ros::WallTime::now();
  for (;;) {
    const ros::WallTime now = ros::WallTime::now();
    const double silence = (now - acknowledged_at_).toSec();
    throwFailure("scan");
    if (!finished_.isZero() && acknowledged_ >= finished_) return;
    if (acknowledged_.isZero() && (now - begin).toSec() > waiting.first_sample) {
      throw core::InputError("scan: no sample came within " + core::fixed(waiting.first_sample, 1) + " s");
    }
    if (!acknowledged_.isZero() && waiting.end_is_announced && silence > waiting.first_sample) {
      throw core::InputError("scan: samples stopped coming before the end of the scan, " +
                             core::fixed(waiting.first_sample, 1) + " s ago");
    }
    if (!acknowledged_.isZero() && !waiting.end_is_announced && silence > waiting.silence) return;
    lock.unlock();
    progress.update("scan", 0.0);
    lock.lock();
    changed_.wait_for(lock, look);
  }
}

ros::WallTime StageResults::lastSampleAt() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return acknowledged_at_;
}

}  // namespace scan_to_path_ros
