// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <tf2_msgs/TFMessage.h>

#include <memory>
#include <vector>

#include "scan_to_path_ros/playback.h"

namespace scan_to_path_ros {

/// Listens to tf2 while a trajectory is played and publishes what a comparison finds: `played_path` and
/// `playback_deviation`, once a second and at the end. To be used from the thread of the handle's callbacks.
class PlaybackWatch {
public:
  explicit PlaybackWatch(const ros::NodeHandle& nodes);

  /// Begins to listen; without a comparison there is nothing to.
  void prepare(std::unique_ptr<PlaybackComparison> comparison);
  bool isPrepared() const { return comparison_ != nullptr; }
  /// Transforms come. From another host they do not as soon as they are subscribed to.
  bool hears() const { return hears_; }

  /// The playback begins, by so much later than it was prepared for: now transforms are compared.
  void begin(const ros::Duration& later);
  /// To be called again and again; `is_done`: all is played, so transforms come for another second at most.
  void look(bool is_done);
  void end();

  void describe(diagnostic_updater::DiagnosticStatusWrapper& status) const;

private:
  void take(const tf2_msgs::TFMessageConstPtr& msg);
  void takeStatic(const tf2_msgs::TFMessageConstPtr& msg);
  void publish();

  ros::NodeHandle nodes_;
  ros::Publisher path_;
  ros::Publisher deviation_;
  ros::Subscriber fixed_;
  ros::Subscriber moving_;  ///< only while they are compared
  std::vector<geometry_msgs::TransformStamped> fixed_transforms_;
  std::unique_ptr<PlaybackComparison> comparison_;
  bool hears_ = false;
  bool compares_ = false;
  ros::WallTime done_at_;
  ros::WallTime published_at_;
};

}  // namespace scan_to_path_ros
