// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/playback.h"

#include <tf2/exceptions.h>
#include <tf2_eigen/tf2_eigen.h>

#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path_ros/conversions.h"
#include "scan_to_path_ros/parameters.h"

namespace scan_to_path_ros {
namespace {

using core::InputError;
using core::geometry::Frame;

constexpr double max_speed = 1000.0;
constexpr const char* tool_frame = "tcp";

void check(const PlaybackOptions& options) {
  if (!(options.speed > 0.0 && options.speed <= max_speed)) {
    throw InputError("playback", "speed", std::to_string(options.speed), "above 0, up to 1000");
  }
  if (!(options.rate >= 1.0 && options.rate <= 1e4)) {
    throw InputError("playback", "rate", std::to_string(options.rate) + " 1/s", "1 to 10000");
  }
}

void check(const trajectory_msgs::JointTrajectory& trajectory) {
  if (trajectory.points.empty()) throw InputError("playback: the trajectory has no points");
  const ros::Duration* before = nullptr;
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const auto& point = trajectory.points[i];
    const std::string at = "playback: trajectory point " + std::to_string(i);
    if (point.positions.size() != trajectory.joint_names.size()) {
      throw InputError(at + " has " + std::to_string(point.positions.size()) + " positions of " +
                       std::to_string(trajectory.joint_names.size()) + " joints");
    }
    for (const double angle : point.positions) {
      if (!std::isfinite(angle)) throw InputError(at + " has a position that is not finite");
    }
    if (before != nullptr && point.time_from_start <= *before)
      throw InputError(at + " is not later than the one before");
    before = &point.time_from_start;
  }
}

}  // namespace

PlaybackOptions playbackOptions(const ros::NodeHandle& nodes) {
  PlaybackOptions options;
  options.speed = parameter(nodes, "speed", options.speed);
  options.rate = parameter(nodes, "rate", options.rate);
  return options;
}

JointPlayback::JointPlayback(const trajectory_msgs::JointTrajectory& trajectory, const PlaybackOptions& options,
                             const ros::Time& begin) {
  check(options);
  check(trajectory);
  for (std::size_t point = 0; point < trajectory.points.size(); ++point) addMove(trajectory, point, options, begin);
  for (std::size_t i = 1; i < states_.size(); ++i) {
    if (states_[i].header.stamp > states_[i - 1].header.stamp) continue;
    throw InputError("playback: speed " + std::to_string(options.speed) +
                     " leaves less than a nanosecond between points");
  }
}

void JointPlayback::addMove(const trajectory_msgs::JointTrajectory& trajectory, std::size_t point,
                            const PlaybackOptions& options, const ros::Time& begin) {
  const auto& to = trajectory.points[point];
  const auto& from = trajectory.points[point > 0 ? point - 1 : 0];
  const double duration = (to.time_from_start - from.time_from_start).toSec();
  const int steps = std::max(1, static_cast<int>(std::ceil(duration / options.speed * options.rate)));
  for (int step = 1; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    sensor_msgs::JointState state;
    state.name = trajectory.joint_names;
    state.position = to.positions;
    if (step < steps) {
      for (std::size_t k = 0; k < state.position.size(); ++k) {
        state.position[k] = from.positions[k] + share * (to.positions[k] - from.positions[k]);
      }
    }
    state.header.stamp = begin + ros::Duration((from.time_from_start.toSec() + share * duration) / options.speed);
    states_.push_back(std::move(state));
  }
  place_.push_back(states_.size() - 1);
}

void JointPlayback::postpone(const ros::Duration& time) {
  for (auto& state : states_) state.header.stamp += time;
}

std::vector<sensor_msgs::JointState> JointPlayback::until(const ros::Time& now) {
  const std::size_t first = next_;
  while (next_ < states_.size() && states_[next_].header.stamp <= now) ++next_;
  return {states_.begin() + static_cast<std::ptrdiff_t>(first), states_.begin() + static_cast<std::ptrdiff_t>(next_)};
}

PlaybackComparison::PlaybackComparison(const core::toolpath::ToolPath& path, const core::MotionPlan& plan,
                                       const JointPlayback& playback) {
  played_.header.frame_id = deviation_.header.frame_id = path.frame;
  for (std::size_t i = 0; i < plan.segment.size(); ++i) {
    const int segment = plan.segment[i];
    const int index = plan.index[i];
    // Points before a waypoint are on the move to it and bear its name.
    if (i + 1 < plan.segment.size() && plan.segment[i + 1] == segment && plan.index[i + 1] == index) continue;
    if (segment < 0 || static_cast<std::size_t>(segment) >= path.segments.size() || index < 0 ||
        static_cast<std::size_t>(index) >= path.segments[static_cast<std::size_t>(segment)].waypoints.size()) {
      throw InputError("playback: trajectory point " + std::to_string(i) + " names segment " + std::to_string(segment) +
                       " index " + std::to_string(index) + ", the path has none such");
    }
    const auto& waypoint = path.segments[static_cast<std::size_t>(segment)].waypoints[static_cast<std::size_t>(index)];
    waiting_.push_back({playback.stamp(i), segment, index, waypoint.pose * path.T_contact_tcp});
  }
}

void PlaybackComparison::postpone(const ros::Duration& time) {
  for (auto& target : waiting_) target.stamp += time;
}

void PlaybackComparison::addTransform(const geometry_msgs::TransformStamped& transform, bool is_static) {
  if (!buffer_.setTransform(transform, "tf", is_static)) return;
  for (; !waiting_.empty(); waiting_.pop_front()) {
    if (compare(waiting_.front())) continue;
    if (is_static || transform.header.stamp - waiting_.front().stamp <= ros::Duration(patience)) return;
    ++deviation_.missing;
  }
}

void PlaybackComparison::finish() {
  for (; !waiting_.empty(); waiting_.pop_front()) deviation_.missing += compare(waiting_.front()) ? 0 : 1;
  deviation_.finished = 1;
}

bool PlaybackComparison::compare(const Target& target) {
  geometry_msgs::TransformStamped msg;
  try {
    msg = buffer_.lookupTransform(played_.header.frame_id, tool_frame, target.stamp);
  } catch (const tf2::TransformException&) {
    return false;
  }
  const Frame T = tf2::transformToEigen(msg);
  ++deviation_.waypoints;
  deviation_.header.stamp = played_.header.stamp = target.stamp;
  const double position = (T.translation() - target.T_path_tcp.translation()).norm();
  if (position > deviation_.position_largest) {
    deviation_.position_largest = position;
    deviation_.position_segment = target.segment;
    deviation_.position_index = target.index;
  }
  const double angle = core::geometry::rotationAngle(target.T_path_tcp.linear(), T.linear());
  if (angle > deviation_.angle_largest) {
    deviation_.angle_largest = angle;
    deviation_.angle_segment = target.segment;
    deviation_.angle_index = target.index;
  }
  geometry_msgs::PoseStamped pose;
  pose.header = played_.header;
  pose.pose = toPose(T);
  played_.poses.push_back(pose);
  return true;
}

}  // namespace scan_to_path_ros
