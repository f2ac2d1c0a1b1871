// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/transform_history.h"

#include <tf2/exceptions.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <iterator>

namespace scan_to_path_ros {

using scan_to_path::geometry::Frame;

TransformHistory::TransformHistory(const TransformHistoryOptions& options)
    : options_(options), buffer_(ros::Duration(options.cache)) {}

void TransformHistory::setOptions(const TransformHistoryOptions& options) {
  const double cache = options_.cache;
  options_ = options;
  options_.cache = cache;
  moving_frame_.clear();
  step_ = Step();
  track_.clear();
  track_begin_ = ros::Time();
}

ros::Duration TransformHistory::add(const geometry_msgs::TransformStamped& transform, bool is_static) {
  const ros::Time stamp = transform.header.stamp;
  ros::Duration went_back;
  const auto known = stamps_.find(transform.child_frame_id);
  if (known != stamps_.end() && known->second.back() - stamp > ros::Duration(options_.max_disorder)) {
    went_back = known->second.back() - stamp;
    buffer_.clear();  // static ones stay
    stamps_.clear();
    step_ = Step();
    track_.clear();
    track_begin_ = ros::Time();
  }
  if (!buffer_.setTransform(transform, "tf", is_static) || is_static) return went_back;
  Stamps& stamps = stamps_[transform.child_frame_id];
  stamps.insert(std::upper_bound(stamps.begin(), stamps.end(), stamp), stamp);
  while (stamps.back() - stamps.front() > ros::Duration(options_.cache)) stamps.pop_front();
  return went_back;
}

TransformHistory::Reach TransformHistory::reach(const ros::Time& stamp) {
  if (moving_frame_.empty() && !findMovingFrame()) return Reach::not_yet;
  const auto found = stamps_.find(moving_frame_);
  if (found == stamps_.end() || found->second.back() < stamp) return Reach::not_yet;
  const Stamps& stamps = found->second;
  if (stamp < stamps.front()) return Reach::before_first;
  const auto after = std::lower_bound(stamps.begin(), stamps.end(), stamp);
  if (after == stamps.begin()) return Reach::known;
  const ros::Time before = *std::prev(after);
  if (*after != stamp && *after - before > ros::Duration(options_.max_joint_gap)) return Reach::gap;
  return jumps(before, *after) ? Reach::jump : Reach::known;
}

bool TransformHistory::jumps(const ros::Time& before, const ros::Time& after) {
  if (before == step_.before && after == step_.after.stamp) return step_.jumps;
  try {
    const SensorPlace from = before == step_.after.stamp ? step_.after : placeOf(before, sensorAt(before));
    const SensorPlace to = placeOf(after, sensorAt(after));
    step_ = {before, to, !isReached(from, to, options_.max_speed)};
    if (track_begin_.isZero()) {  // a robot that waited did so elsewhere
      track_begin_ = after - before > ros::Duration(options_.max_joint_gap) ? after : before;
    }
    return step_.jumps;
  } catch (const tf2::TransformException&) {
    return false;  // what is missing is found missing when the sensor is asked for
  }
}

/// A reading that nothing could reach in its time is none of the robot's.
void TransformHistory::follow(const ros::Time& until) {
  if (track_begin_.isZero()) return;
  const Stamps& stamps = stamps_[moving_frame_];
  const auto begin = track_.size() == 0 ? std::lower_bound(stamps.begin(), stamps.end(), track_begin_)
                                        : std::upper_bound(stamps.begin(), stamps.end(), track_.end());
  for (auto stamp = begin; stamp != stamps.end() && *stamp <= until; ++stamp) {
    try {
      track_.add(placeOf(*stamp, sensorAt(*stamp)), options_.max_speed);
    } catch (const tf2::TransformException&) {
      continue;  // the sensor's other frames are not known there
    }
  }
}

Frame TransformHistory::sensorAt(const ros::Time& stamp) const {
  return tf2::transformToEigen(buffer_.lookupTransform(options_.base_frame, options_.sensor_frame, stamp));
}

bool TransformHistory::findMovingFrame() {
  std::string frame = options_.sensor_frame;
  std::string parent;
  while (frame != options_.base_frame) {
    if (stamps_.count(frame) > 0) {
      moving_frame_ = frame;
      return true;
    }
    if (!buffer_._getParent(frame, ros::Time(), parent)) return false;
    frame = parent;
  }
  return false;
}

}  // namespace scan_to_path_ros
