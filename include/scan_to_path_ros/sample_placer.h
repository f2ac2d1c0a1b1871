// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <scan_to_path/ScanSamples.h>
#include <tf2/buffer_core.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/stages.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path_ros {

namespace core = scan_to_path;

struct SamplePlacerOptions {
  std::string base_frame = "base_link";
  std::string sensor_frame = "sensor";
  double max_joint_gap = 0.05;  ///< a sample between transforms farther apart is dropped [s]
  double max_wait = 1.0;        ///< a sample this much older than the newest one waits no longer for its transform [s]
  double clock_offset = 0.0;    ///< added to the sensor's stamps to get tf's [s]
  double cache = 60.0;          ///< tf history kept [s]
};

/// Places range samples in the base frame by tf2 at each sample's own stamp: it waits for transforms that are late,
/// never uses a stale one, and counts what it leaves out. Not thread-safe.
class SamplePlacer {
public:
  explicit SamplePlacer(const SamplePlacerOptions& options);

  /// Forgets samples and cloud, keeps transforms. The cache is the constructor's.
  void restart(const SamplePlacerOptions& options);

  void addTransform(const geometry_msgs::TransformStamped& transform, bool is_static);

  /// Samples are placed as soon as transforms on both sides of their stamp are there. Throws InputError for a message
  /// of another frame, sizes that do not fit, offsets that do not rise, stamps before those that came already.
  void addSamples(const core::ScanSamples& samples);

  /// Gives up on samples that still wait, counting them as "no transform".
  void finish();

  /// The stamp up to which every sample is placed or left out; zero before the first.
  ros::Time acknowledged() const { return acknowledged_; }
  std::size_t waiting() const { return waiting_.size(); }
  const SamplePlacerOptions& options() const { return options_; }
  const std::vector<core::scan::Dropped>& dropped() const { return dropped_; }
  std::size_t samplesIn() const { return samples_in_; }
  const core::scan::ScanCloud& cloud() const { return cloud_; }
  ros::Time start() const { return start_; }

  /// Cloud, viewing direction and counts, as the fit takes them; the placer is empty afterwards.
  /// Throws InputError when nothing could be placed, saying why.
  core::pipeline::ScanStage take();

private:
  struct Sample {
    ros::Time stamp;
    double time;   ///< since start_ [s]
    double range;  ///< [m]
  };
  enum class Outcome { done, later };

  Outcome place(const Sample& sample);
  void addPoint(const Sample& sample, const ros::Time& stamp);
  void placeWaiting();
  void drop(const char* reason);
  bool isInGap(const ros::Time& stamp) const;
  void findMovingFrame();

  SamplePlacerOptions options_;
  tf2::BufferCore buffer_;
  std::map<std::string, std::deque<ros::Time>> stamps_;  ///< of each moving frame's transforms, rising
  std::string moving_frame_;  ///< the frame nearest to the sensor that moves; empty while not known
  std::deque<Sample> waiting_;
  core::scan::ScanCloud cloud_;
  core::geometry::Vector3 beam_sum_ = core::geometry::Vector3::Zero();
  std::vector<core::scan::Dropped> dropped_;
  std::size_t samples_in_ = 0;
  ros::Time start_;
  ros::Time acknowledged_;
};

}  // namespace scan_to_path_ros
