// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/time.h>
#include <scan_to_path/MotionPlan.h>
#include <scan_to_path/PlaybackDeviation.h>
#include <sensor_msgs/JointState.h>
#include <tf2/buffer_core.h>
#include <trajectory_msgs/JointTrajectory.h>

#include <deque>
#include <vector>

#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path_ros {

struct PlaybackOptions {
  double speed = 1.0;  ///< of the playback against the trajectory's own times, in (0, 1000]
  double rate = 50.0;  ///< of joint states between points that are farther apart [1/s]
};

/// From the parameters `speed` and `rate`.
PlaybackOptions playbackOptions(const ros::NodeHandle& nodes);

/// A trajectory as joint states: one for every point, at its very time, and some on the joint-linear moves between.
class JointPlayback {
public:
  /// Throws InputError for an empty trajectory, times that do not rise, sizes that do not fit, numbers that are not
  /// finite, options out of range.
  JointPlayback(const trajectory_msgs::JointTrajectory& trajectory, const PlaybackOptions& options,
                const ros::Time& begin);

  /// The joint states up to `now` that were not asked for before.
  std::vector<sensor_msgs::JointState> until(const ros::Time& now);

  bool isDone() const { return next_ == states_.size(); }
  double fraction() const { return static_cast<double>(next_) / static_cast<double>(states_.size()); }

  /// Plays everything by so much later; nothing may have been played.
  void postpone(const ros::Duration& time);

  /// When the point is played.
  ros::Time stamp(std::size_t point) const { return states_[place_[point]].header.stamp; }
  const sensor_msgs::JointState& last() const { return states_.back(); }

private:
  void addMove(const trajectory_msgs::JointTrajectory& trajectory, std::size_t point, const PlaybackOptions& options,
               const ros::Time& begin);

  std::vector<sensor_msgs::JointState> states_;
  std::vector<std::size_t> place_;  ///< of each trajectory point in states_
  std::size_t next_ = 0;
};

/// The tool's pose by tf2 at each waypoint of a played trajectory, against the pose that was planned.
class PlaybackComparison {
public:
  /// `plan` says which points of the trajectory are waypoints; its joint states are `playback`'s. Poses are compared in
  /// the path's frame. Throws InputError when the plan names waypoints that the path does not have.
  PlaybackComparison(const scan_to_path::toolpath::ToolPath& path, const scan_to_path::MotionPlan& plan,
                     const JointPlayback& playback);

  /// As the playback is.
  void postpone(const ros::Duration& time);

  void addTransform(const geometry_msgs::TransformStamped& transform, bool is_static);

  /// Counts waypoints whose transforms did not come as missing.
  void finish();

  const scan_to_path::PlaybackDeviation& deviation() const { return deviation_; }
  /// Where the tool centre point was at the waypoints.
  const nav_msgs::Path& path() const { return played_; }
  std::size_t waiting() const { return waiting_.size(); }

private:
  struct Target {
    ros::Time stamp;
    int segment;
    int index;
    scan_to_path::geometry::Frame T_path_tcp;
  };

  static constexpr double patience = 1.0;  ///< [s] of stamps that come before a transform that may yet come

  /// False while there are no transforms for it.
  bool compare(const Target& target);

  tf2::BufferCore buffer_{ros::Duration(60.0)};
  std::deque<Target> waiting_;
  scan_to_path::PlaybackDeviation deviation_;
  nav_msgs::Path played_;
};

}  // namespace scan_to_path_ros
