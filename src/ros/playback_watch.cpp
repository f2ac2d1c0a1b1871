// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/playback_watch.h"

namespace scan_to_path_ros {
namespace {

constexpr double watch_period = 1.0;      // of what is published while the path grows [s of wall time]
constexpr double latest_transform = 1.0;  // after the end of the playback [s of wall time]

}  // namespace

PlaybackWatch::PlaybackWatch(const ros::NodeHandle& nodes) : nodes_(nodes) {
  path_ = nodes_.advertise<nav_msgs::Path>("played_path", 1, true);
  deviation_ = nodes_.advertise<scan_to_path::PlaybackDeviation>("playback_deviation", 1, true);
  fixed_ = nodes_.subscribe("/tf_static", 100, &PlaybackWatch::takeStatic, this);
}

void PlaybackWatch::prepare(std::unique_ptr<PlaybackComparison> comparison) {
  end();
  comparison_ = std::move(comparison);
  if (!comparison_) return;
  for (const auto& transform : fixed_transforms_) comparison_->addTransform(transform, true);
  moving_ = nodes_.subscribe("/tf", 20000, &PlaybackWatch::take, this);
}

void PlaybackWatch::begin(const ros::Duration& later) {
  if (!comparison_) return;
  comparison_->postpone(later);
  compares_ = true;
  publish();
}

void PlaybackWatch::look(bool is_done) {
  if (!compares_ || comparison_->deviation().finished != 0) return;
  const ros::WallTime now = ros::WallTime::now();
  if (is_done && done_at_.isZero()) done_at_ = now;
  const bool is_over = is_done && (comparison_->waiting() == 0 || (now - done_at_).toSec() > latest_transform);
  if (is_over) {
    comparison_->finish();
    moving_.shutdown();
  }
  if (is_over || (now - published_at_).toSec() > watch_period) publish();
}

void PlaybackWatch::end() {
  if (compares_) publish();
  moving_.shutdown();
  comparison_.reset();
  hears_ = compares_ = false;
  done_at_ = ros::WallTime();
}

void PlaybackWatch::publish() {
  published_at_ = ros::WallTime::now();
  path_.publish(boost::make_shared<nav_msgs::Path>(comparison_->path()));
  deviation_.publish(boost::make_shared<scan_to_path::PlaybackDeviation>(comparison_->deviation()));
}

void PlaybackWatch::take(const tf2_msgs::TFMessageConstPtr& msg) {
  hears_ = true;
  if (!compares_ || comparison_->waiting() == 0) return;
  for (const auto& transform : msg->transforms) comparison_->addTransform(transform, false);
}

/// They come once, for every playback there will be.
void PlaybackWatch::takeStatic(const tf2_msgs::TFMessageConstPtr& msg) {
  fixed_transforms_.insert(fixed_transforms_.end(), msg->transforms.begin(), msg->transforms.end());
  if (!comparison_) return;
  for (const auto& transform : msg->transforms) comparison_->addTransform(transform, true);
}

void PlaybackWatch::describe(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  if (!comparison_) return;
  const auto& off = comparison_->deviation();
  if (off.finished != 0 && off.missing > 0)
    status.summary(diagnostic_msgs::DiagnosticStatus::ERROR, "transforms of the tool are missing");
  status.add("waypoints", off.waypoints);
  status.add("waypoints without a transform", off.missing);
  status.add("largest deviation [m]", off.position_largest);
  status.add("largest deviation [rad]", off.angle_largest);
}

}  // namespace scan_to_path_ros
