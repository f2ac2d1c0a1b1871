// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <scan_to_path/FittedScan.h>
#include <scan_to_path/MotionPlan.h>
#include <scan_to_path/PlannedPath.h>
#include <scan_to_path/ScanInfo.h>
#include <scan_to_path/StageProgress.h>
#include <scan_to_path/StageReport.h>
#include <std_msgs/Header.h>

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path_ros {

/// What the stages' nodelets publish, held until a job asks for it. Messages come on a queue of their own, so that a
/// job may wait for them in a callback.
class StageResults {
public:
  using Cloud = scan_to_path::scan::ScanCloud;

  /// `silence` [s of wall time]: a stage that says nothing for so long is given up.
  StageResults(const ros::NodeHandle& nodes, double silence);

  /// Forgets what earlier jobs left.
  void clear();

  /// The result of a stage; waits for it, passing the stage's progress on. Throws InputError with the stage's own
  /// words when it failed or says nothing any more, Interrupted when cancelled, std::runtime_error for its bugs.
  boost::shared_ptr<const Cloud> cloud(const scan_to_path::Progress& progress);
  scan_to_path::ScanInfoConstPtr scanInfo(const scan_to_path::Progress& progress);
  scan_to_path::FittedScanConstPtr fittedScan(const scan_to_path::Progress& progress);
  scan_to_path::PlannedPathConstPtr plannedPath(const scan_to_path::Progress& progress);
  scan_to_path::MotionPlanConstPtr motionPlan(const scan_to_path::Progress& progress);

  /// Waits for the end of the scan: the emulator's word, or samples that stopped coming after the first ones.
  /// Throws InputError when none came at all.
  void waitForScan(const scan_to_path::Progress& progress, double first_sample, double silence);

private:
  template <class Message>
  void hold(ros::NodeHandle& nodes, const std::string& topic, boost::shared_ptr<const Message>& held);
  template <class Message>
  boost::shared_ptr<const Message> waitFor(const char* stage, boost::shared_ptr<const Message>& held,
                                           const scan_to_path::Progress& progress);
  void throwFailure(const scan_to_path::StageReport& report) const;

  double silence_;
  std::mutex mutex_;
  std::condition_variable changed_;
  ros::WallTime heard_;
  std::map<std::string, double> fractions_;
  std::map<std::string, scan_to_path::StageReport> failures_;
  boost::shared_ptr<const Cloud> cloud_;
  scan_to_path::ScanInfoConstPtr scan_info_;
  scan_to_path::FittedScanConstPtr fitted_scan_;
  scan_to_path::PlannedPathConstPtr planned_path_;
  scan_to_path::MotionPlanConstPtr motion_plan_;
  ros::Time acknowledged_;
  ros::WallTime acknowledged_at_;
  ros::Time finished_;
  ros::CallbackQueue queue_;
  std::vector<ros::Subscriber> subscribers_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace scan_to_path_ros
