// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <diagnostic_updater/diagnostic_updater.h>
#include <nodelet/nodelet.h>
#include <scan_to_path/PlannedPath.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>
#include <optional>

#include "scan_to_path/common/error.h"
#include "scan_to_path_ros/conversions.h"
#include "scan_to_path_ros/parameters.h"
#include "scan_to_path_ros/playback_watch.h"

namespace scan_to_path_nodelets {

/// Shows a planned trajectory with the robot of rviz: plays it as joint states, then stands at its end until stopped,
/// and compares where tf2 has the tool with the planned path. Never in a cell with a real robot: that one says itself
/// where it is.
class TrajectoryPlayer : public nodelet::Nodelet {
  static constexpr double period = 0.02;       ///< of looks at the clock [s of wall time]
  static constexpr double hold_period = 0.25;  ///< of the joint states at the end [s of wall time]
  static constexpr double late = 1.0;          ///< after which a scan's samples come no more [s of wall time]
  static constexpr double deaf = 5.0;          ///< without any transform it plays all the same [s of wall time]

  void onInit() override {
    ros::NodeHandle& nodes = getNodeHandle();
    joints_ = nodes.advertise<sensor_msgs::JointState>("joint_states", 20000);
    active_ = nodes.advertise<std_msgs::Bool>("playback_active", 1, true);
    watch_ = std::make_unique<scan_to_path_ros::PlaybackWatch>(nodes);
    subscribers_ = {nodes.subscribe("joint_trajectory", 1, &TrajectoryPlayer::takeTrajectory, this),
                    nodes.subscribe("motion_plan", 1, &TrajectoryPlayer::takePlan, this),
                    nodes.subscribe("planned_path", 1, &TrajectoryPlayer::takePath, this),
                    nodes.subscribe("scan_acknowledged", 1, &TrajectoryPlayer::noteScan, this)};
    start_ = getPrivateNodeHandle().advertiseService("start", &TrajectoryPlayer::start, this);
    stop_ = getPrivateNodeHandle().advertiseService("stop", &TrajectoryPlayer::stop, this);
    timer_ = nodes.createWallTimer(ros::WallDuration(period), [this](const ros::WallTimerEvent&) { step(); });
    diagnostics_ = std::make_unique<diagnostic_updater::Updater>(nodes, getPrivateNodeHandle(), getName());
    diagnostics_->setHardwareID("none");
    diagnostics_->add("playback", this, &TrajectoryPlayer::diagnose);
    diagnostics_timer_ = nodes.createWallTimer(ros::WallDuration(1.0),
                                               [this](const ros::WallTimerEvent&) { diagnostics_->force_update(); });
    setActive(false);
    scan_to_path_ros::playbackOptions(getPrivateNodeHandle());  // to be seen before the first playback
    isRealRobot();
  }

  void takeTrajectory(const trajectory_msgs::JointTrajectoryConstPtr& msg) { trajectory_ = msg; }
  void takePlan(const scan_to_path::MotionPlanConstPtr& msg) {
    plan_ = msg;
    scanned_ = ros::WallTime();  // the scan is over
  }
  void noteScan(const std_msgs::HeaderConstPtr&) { scanned_ = ros::WallTime::now(); }

  /// The path as it is driven: a dry run's is off the part, by the configuration of the job that is under way.
  void takePath(const scan_to_path::PlannedPathConstPtr& msg) {
    try {
      const auto options = scan_to_path_ros::readJobOptions(getNodeHandle());
      const auto cell = scan_to_path::pipeline::makeCell(options.cell, scan_to_path_ros::packagePath());
      driven_ = scan_to_path::pipeline::airRun(scan_to_path_ros::fromMsg(*msg), cell, options.program).planned.path;
      path_stamp_ = msg->header.stamp;
    } catch (const scan_to_path::InputError& error) {
      NODELET_ERROR("planned path: %s", error.what());
    }
  }

  bool start(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    try {
      begin();
      response.success = 1;
      response.message = std::to_string(trajectory_->points.size()) + " points" +
                         (watch_->isPrepared() ? "" : ", no path to compare with");
    } catch (const scan_to_path::InputError& error) {
      response.message = error.what();
    }
    return true;
  }

  bool stop(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    response.success = 1;
    end();
    return true;
  }

  void end() {
    is_asked_ = false;
    watch_->end();
    playback_.reset();
    setActive(false);
  }

  bool isRealRobot() { return scan_to_path_ros::parameter(getPrivateNodeHandle(), "real_robot", false); }

  void begin() {
    if (isRealRobot()) throw scan_to_path::InputError("a real robot publishes joint_states; play back with sim:=true");
    if (!trajectory_)
      throw scan_to_path::InputError("no trajectory has come on " + getNodeHandle().resolveName("joint_trajectory"));
    if ((ros::WallTime::now() - scanned_).toSec() < late) throw scan_to_path::InputError("a scan is running");
    if (playback_) end();
    const scan_to_path_ros::JointPlayback playback(
        *trajectory_, scan_to_path_ros::playbackOptions(getPrivateNodeHandle()), ros::Time::now());
    watch_->prepare(isPlanned() ? std::make_unique<scan_to_path_ros::PlaybackComparison>(*driven_, *plan_, playback)
                                : nullptr);
    playback_ = playback;
    asked_at_ = ros::WallTime::now();
    is_asked_ = true;
  }

  /// Once transforms are heard, of the robot that stands and says so a few times a second.
  void play() {
    if (watch_->isPrepared() && !watch_->hears() && (ros::WallTime::now() - asked_at_).toSec() < deaf) return;
    is_asked_ = false;
    last_look_ = ros::Time::now();
    setActive(true);
    // A moment for that robot to fall silent.
    const ros::Duration later = last_look_ + ros::Duration(5 * period) - playback_->stamp(0);
    playback_->postpone(later);
    watch_->begin(later);
  }

  /// Path and plan are those of the trajectory.
  bool isPlanned() const {
    return driven_ && plan_ && plan_->header.stamp == trajectory_->header.stamp && path_stamp_ == plan_->header.stamp &&
           plan_->time.size() == trajectory_->points.size();
  }

  void step() {
    if (is_asked_) play();
    if (!playback_ || is_asked_) return;
    const ros::Time now = ros::Time::now();
    if (now < last_look_) {
      NODELET_ERROR("the clock went back while playing; stopped");
      return end();
    }
    last_look_ = now;
    for (auto& state : playback_->until(now))
      joints_.publish(boost::make_shared<sensor_msgs::JointState>(std::move(state)));
    if (playback_->isDone()) stand(now);
    watch_->look(playback_->isDone());
  }

  /// Stays at the end.
  void stand(const ros::Time& now) {
    const ros::WallTime wall = ros::WallTime::now();
    if ((wall - held_at_).toSec() < hold_period || now <= playback_->last().header.stamp) return;
    held_at_ = wall;
    const auto state = boost::make_shared<sensor_msgs::JointState>(playback_->last());
    state->header.stamp = now;
    joints_.publish(state);
  }

  void setActive(bool active) {
    std_msgs::Bool message;
    message.data = static_cast<std::uint8_t>(active);
    active_.publish(message);
  }

  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
    using diagnostic_msgs::DiagnosticStatus;
    if (!playback_) return status.summary(DiagnosticStatus::OK, "idle");
    status.summary(DiagnosticStatus::OK, playback_->isDone() ? "at the end" : "playing");
    status.add("played", playback_->fraction());
    watch_->describe(status);
  }

  trajectory_msgs::JointTrajectoryConstPtr trajectory_;
  scan_to_path::MotionPlanConstPtr plan_;
  std::optional<scan_to_path::toolpath::ToolPath> driven_;
  ros::Time path_stamp_;
  std::optional<scan_to_path_ros::JointPlayback> playback_;
  std::unique_ptr<scan_to_path_ros::PlaybackWatch> watch_;
  bool is_asked_ = false;  ///< to play what is prepared
  ros::Time last_look_;
  ros::WallTime asked_at_;
  ros::WallTime held_at_;
  ros::WallTime scanned_;
  ros::Publisher joints_;
  ros::Publisher active_;
  std::vector<ros::Subscriber> subscribers_;
  ros::ServiceServer start_;
  ros::ServiceServer stop_;
  ros::WallTimer timer_;
  std::unique_ptr<diagnostic_updater::Updater> diagnostics_;
  ros::WallTimer diagnostics_timer_;
};

}  // namespace scan_to_path_nodelets

PLUGINLIB_EXPORT_CLASS(scan_to_path_nodelets::TrajectoryPlayer, nodelet::Nodelet)
