// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/nodelet_runner.h"

#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/scan/cloud_io.h"
#include "scan_to_path_ros/conversions.h"
#include "scan_to_path_ros/parameters.h"

namespace scan_to_path_ros {
namespace {

namespace pipeline = scan_to_path::pipeline;

constexpr const char* emulator_start = "scan_emulator/start";
constexpr const char* emulator_stop = "scan_emulator/stop";
constexpr const char* accumulator_start = "scan_accumulator/start";
constexpr const char* accumulator_stop = "scan_accumulator/stop";
constexpr const char* player_stop = "trajectory_player/stop";

}  // namespace

NodeletRunner::NodeletRunner(const ros::NodeHandle& nodes, StageResults& results, const ScanWaiting& waiting,
                             const pipeline::JobRequest& request, const pipeline::JobOptions& options,
                             const pipeline::Cell& cell)
    : StageRunner(request, options, cell), nodes_(nodes), results_(results), waiting_(waiting) {}

NodeletRunner::~NodeletRunner() {
  std_srvs::Trigger stop;
  for (const char* service : {emulator_stop, accumulator_stop}) {
    if (exists(service)) ros::service::call(nodes_.resolveName(service), stop);
  }
}

bool NodeletRunner::exists(const std::string& service) const {
  return ros::service::exists(nodes_.resolveName(service), false);
}

void NodeletRunner::call(const std::string& service) const {
  const std::string name = nodes_.resolveName(service);
  std_srvs::Trigger trigger;
  if (!ros::service::call(name, trigger)) {
    checkMaster();
    throw scan_to_path::InputError(name + ": nobody answers; is its nodelet running?");
  }
  if (trigger.response.success == 0) throw scan_to_path::InputError(name + ": " + trigger.response.message);
}

void NodeletRunner::await(const std::string& service, const scan_to_path::Progress& progress) const {
  const ros::WallTime limit = ros::WallTime::now() + ros::WallDuration(waiting_.first_sample);
  while (!exists(service) && ros::WallTime::now() < limit) {
    checkMaster();
    progress.update("scan", 0.0);
    ros::WallDuration(0.02).sleep();
  }
}

void NodeletRunner::read(const scan_to_path::Progress& progress) {
  progress.update("scan", 0.0);
  results_.clear();
  if (exists(player_stop)) call(player_stop);
  await(accumulator_start, progress);
  call(accumulator_start);
  // A cell with a real robot has no emulator: its samples come when the robot moves.
  const bool emulated = nodes_.param("emulated", exists(emulator_start));
  waiting_.end_is_announced = emulated;
  if (emulated) {
    await(emulator_start, progress);
    call(emulator_start);
  } else if (!jobBag(nodes_).empty()) {
    throw scan_to_path::InputError(jobBag(nodes_) +
                                   ": a cell with a real robot replays nothing; bring it up with sim:=true");
  }
}

pipeline::ScanStage NodeletRunner::scan(const scan_to_path::Progress& progress) {
  results_.waitForScan(progress, waiting_);
  scanned_ = results_.lastSampleAt();
  results_.clear();
  call("scan_accumulator/finish");
  const auto info = results_.scanInfo(progress);
  return scanStage(results_.cloud(progress), *info);
}

pipeline::JobInput NodeletRunner::input(const pipeline::ScanStage& scanned) {
  scan_to_path::geometry::Frame T_cloud_sensor = scan_to_path::geometry::Frame::Identity();
  T_cloud_sensor.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), scanned.mean_beam).toRotationMatrix();
  scan_to_path::program::ProgramFile record = {"scan.pcd",
                                               scan_to_path::scan::formatPcd(*scanned.cloud, T_cloud_sensor)};
  const std::string sha256 = scan_to_path::sha256(record.content);
  return {record.name, sha256, pipeline::InputKind::cloud, pipeline::Units::m, std::move(record)};
}

pipeline::FitStage NodeletRunner::fit(const pipeline::ScanStage&, const scan_to_path::Progress& progress) {
  return fromMsg(*results_.fittedScan(progress));
}

pipeline::PathStage NodeletRunner::path(const scan_to_path::process::Planner&, const pipeline::FitStage&,
                                        const scan_to_path::Progress& progress) {
  const auto planned = results_.plannedPath(progress);
  path_delay_ = (ros::WallTime::now() - scanned_).toSec();
  return fromMsg(*planned);
}

pipeline::MotionStage NodeletRunner::motion(const pipeline::PathStage&, const scan_to_path::Progress& progress) {
  return fromMsg(*results_.motionPlan(progress));
}

bool NodeletRunner::accepts(const scan_to_path::Progress& progress) {
  return review_ == nullptr || review_->wait(progress);
}

}  // namespace scan_to_path_ros
