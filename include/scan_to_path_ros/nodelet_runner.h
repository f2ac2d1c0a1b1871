// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "scan_to_path/pipeline/stage_runner.h"
#include "scan_to_path_ros/review.h"
#include "scan_to_path_ros/stage_results.h"

namespace scan_to_path_ros {

/// Has the cell's nodelets run a job's stages: starts the scan, ends it, and takes what they publish.
class NodeletRunner : public scan_to_path::pipeline::StageRunner {
public:
  NodeletRunner(const ros::NodeHandle& nodes, StageResults& results, const ScanWaiting& waiting,
                const scan_to_path::pipeline::JobRequest& request, const scan_to_path::pipeline::JobOptions& options,
                const scan_to_path::pipeline::Cell& cell);
  /// Stops an emulator that still scans, and whoever still takes samples.
  ~NodeletRunner() override;

  void read(const scan_to_path::Progress& progress) override;
  scan_to_path::pipeline::ScanStage scan(const scan_to_path::Progress& progress) override;
  scan_to_path::pipeline::JobInput input(const scan_to_path::pipeline::ScanStage& scanned) override;
  scan_to_path::pipeline::FitStage fit(const scan_to_path::pipeline::ScanStage& scanned,
                                       const scan_to_path::Progress& progress) override;
  scan_to_path::pipeline::PathStage path(const scan_to_path::process::Planner& planner,
                                         const scan_to_path::pipeline::FitStage& fitted,
                                         const scan_to_path::Progress& progress) override;
  scan_to_path::pipeline::MotionStage motion(const scan_to_path::pipeline::PathStage& driven,
                                             const scan_to_path::Progress& progress) override;

  /// Waits for the word of who reviews the job; without a reviewer: yes.
  bool accepts(const scan_to_path::Progress& progress) override;
  void setReview(Review* review) { review_ = review; }

  /// From the last sample placed until the path was planned [s of wall time]; nothing while there is no path.
  std::optional<double> pathDelay() const { return path_delay_; }

private:
  /// Throws InputError with the service's own words when it refuses or is not there.
  void call(const std::string& service) const;
  bool exists(const std::string& service) const;
  /// Until the service is there, as when its host comes up later; as long as for a first sample, at most.
  void await(const std::string& service, const scan_to_path::Progress& progress) const;

  ros::NodeHandle nodes_;
  StageResults& results_;
  ScanWaiting waiting_;
  Review* review_ = nullptr;
  ros::WallTime scanned_;
  std::optional<double> path_delay_;
};

}  // namespace scan_to_path_ros
