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

struct ScanWaiting {
  double first_sample = 10.0;     ///< until the first sample comes [s of wall time]
  double silence = 2.0;           ///< after the last one, when nobody says that the scan has ended [s of wall time]
  bool end_is_announced = false;  ///< scan_finished will come: silence is no end then, but a failure after first_sample
};

/// What the stages' nodelets publish, held until a job asks for it. From the scan's information on, only messages with
/// its stamp count: what stages of a cancelled job still send is not taken for this one's. Messages come on a queue of
/// their own, so that a job may wait for them in a callback.
class StageResults {
public:
  using Cloud = scan_to_path::scan::ScanCloud;

  /// `silence` [s of wall time]: a stage that says nothing for so long is given up.
  StageResults(const ros::NodeHandle& nodes, double silence);

  /// Forgets what earlier jobs left: before the scan starts, and again before it is finished.
  void clear();

  /// The result of a stage; waits for it, passing the stage's progress on. Throws InputError with the stage's own
  /// words when it failed or says nothing any more, Interrupted when cancelled, std::runtime_error for its bugs.
  /// The scan's information comes first; its stamp is the job's from then on.
  scan_to_path::ScanInfoConstPtr scanInfo(const scan_to_path::Progress& progress);
  boost::shared_ptr<const Cloud> cloud(const scan_to_path::Progress& progress);
  scan_to_path::FittedScanConstPtr fittedScan(const scan_to_path::Progress& progress);
  scan_to_path::PlannedPathConstPtr plannedPath(const scan_to_path::Progress& progress);
  scan_to_path::MotionPlanConstPtr motionPlan(const scan_to_path::Progress& progress);

  /// Waits for the end of the scan: the word of who plays it, or, when nobody will say so, samples that stopped coming
  /// after the first ones. Throws InputError when none came at all, or fewer than announced.
  void waitForScan(const scan_to_path::Progress& progress, const ScanWaiting& waiting);

  /// When the last sample of the scan was heard to be placed.
  ros::WallTime lastSampleAt() const;

private:
  template <class Message>
  void hold(ros::NodeHandle& nodes, const std::string& topic, boost::shared_ptr<const Message>& held);
  template <class Message>
  boost::shared_ptr<const Message> waitFor(const char* stage, boost::shared_ptr<const Message>& held,
                                           const scan_to_path::Progress& progress);
  bool isOfThisJob(const ros::Time& stamp) const { return job_.isZero() || stamp == job_; }
  /// Throws what the stage reported, if it did.
  void throwFailure(const std::string& stage) const;

  double silence_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  ros::WallTime heard_;
  std::map<std::string, double> fractions_;
  std::map<std::string, scan_to_path::StageReport> failures_;
  boost::shared_ptr<const Cloud> cloud_;
  scan_to_path::ScanInfoConstPtr scan_info_;
  scan_to_path::FittedScanConstPtr fitted_scan_;
  scan_to_path::PlannedPathConstPtr planned_path_;
  scan_to_path::MotionPlanConstPtr motion_plan_;
  ros::Time job_;  ///< stamp of the scan; zero while not known
  ros::Time acknowledged_;
  ros::WallTime acknowledged_at_;
  ros::Time finished_;
  ros::CallbackQueue queue_;
  std::vector<ros::Subscriber> subscribers_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace scan_to_path_ros
