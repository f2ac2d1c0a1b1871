// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <deque>
#include <map>
#include <string>

#include "scan_to_path/geometry/frames.h"
#include "scan_to_path_ros/sensor_track.h"

namespace scan_to_path_ros {

struct TransformHistoryOptions {
  std::string base_frame = "base_link";
  std::string sensor_frame = "sensor";
  double max_joint_gap = 0.05;  ///< readings farther apart are a gap [s]
  double max_speed = 2.0;       ///< readings between which the sensor is faster are a jump [m/s]
  double max_disorder =
      1.0;              ///< a transform this much older than its frame's newest means that the clock went back [s]
  double cache = 60.0;  ///< history kept [s]
};

/// Where the sensor was, by tf2, and whether the transforms around a stamp can be trusted to say so.
class TransformHistory {
public:
  explicit TransformHistory(const TransformHistoryOptions& options);

  /// New options; the history stays, and so does its length.
  void setOptions(const TransformHistoryOptions& options);

  /// Returns how far the clock went back: then all but static transforms are forgotten before this one is kept; zero
  /// otherwise. Transforms that are not finite are left out, as tf2 does.
  ros::Duration add(const geometry_msgs::TransformStamped& transform, bool is_static);

  /// What the history says of a stamp. Only `known` is to be used.
  enum class Reach { known, not_yet, before_first, gap, jump };
  Reach reach(const ros::Time& stamp);

  /// Adds the readings up to `until` to the track, which begins where reach() found the first stamp between two. What
  /// comes later than this out of order is not followed.
  void follow(const ros::Time& until);

  /// The sensor at all readings followed since the options were set last.
  const SensorTrack& track() const { return track_; }

  /// T_base_sensor, interpolated to the stamp. Throws tf2::TransformException when frames are missing.
  scan_to_path::geometry::Frame sensorAt(const ros::Time& stamp) const;

private:
  using Stamps = std::deque<ros::Time>;

  bool findMovingFrame();
  bool jumps(const ros::Time& before, const ros::Time& after);

  TransformHistoryOptions options_;
  tf2::BufferCore buffer_;
  std::map<std::string, Stamps> stamps_;  ///< of each moving frame's transforms, rising
  std::string moving_frame_;              ///< the frame nearest to the sensor that moves; empty while not known
  /// The pair of readings that was looked at last for a jump.
  struct Step {
    ros::Time before;
    SensorPlace after;
    bool jumps = false;
  } step_;
  SensorTrack track_;
  ros::Time track_begin_;  ///< zero before the scan
};

}  // namespace scan_to_path_ros
