// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <scan_to_path/ScanSamples.h>

#include <deque>
#include <vector>

#include "scan_to_path/pipeline/stages.h"
#include "scan_to_path/scan/scan_cloud.h"
#include "scan_to_path_ros/transform_history.h"

namespace scan_to_path_ros {

namespace core = scan_to_path;

struct SamplePlacerOptions : TransformHistoryOptions {
  double max_wait = 1.0;         ///< a sample this much older than the newest one waits no longer for its transform [s]
  double clock_offset = 0.0;     ///< added to the sensor's stamps to get tf's [s]
  double max_joint_jump = 5e-5;  ///< see checkSensorJumps [rad]
  core::pipeline::ReportOptions limits;
  double range_min = 0.0;  ///< nearest and farthest that the sensor measures: beyond them it rests at its end [m]
  double range_max = 100.0;
};

/// Places range samples in the base frame by tf2 at each sample's own stamp: it waits for transforms that are late or
/// out of order, never uses a stale one, nor one across a gap or a jump, and counts what it leaves out. When the
/// transforms' clock goes back it forgets those of the time that never was, and the scan fails. Not thread-safe.
class SamplePlacer {
public:
  explicit SamplePlacer(const SamplePlacerOptions& options);

  /// Forgets samples and cloud, keeps transforms. The cache is the constructor's.
  void restart(const SamplePlacerOptions& options);

  void addTransform(const geometry_msgs::TransformStamped& transform, bool is_static);

  /// Samples are placed as soon as transforms on both sides of their stamp are there. Throws InputError for a message
  /// of another frame, sizes that do not fit, offsets that do not rise, stamps before those that came already; its
  /// samples are counted as "refused".
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
  /// Throws InputError when nothing could be placed, saying why, the clock went back on the way, or the
  /// sensor jumped.
  core::pipeline::ScanStage take();

private:
  struct Sample {
    ros::Time stamp;
    double time;   ///< since start_ [s]
    double range;  ///< [m]
  };
  enum class Outcome { done, later };

  Outcome place(const Sample& sample);
  void addSample(const Sample& sample, const ros::Time& stamp);
  void addPoint(const Sample& sample, const core::geometry::Frame& T_base_sensor);
  void placeWaiting();
  ros::Time followed() const;  ///< the last acknowledged sample on the transforms' clock
  void leaveOut(const Sample& sample, const char* reason);
  void giveUp(const char* reason);
  void check(const core::ScanSamples& samples) const;
  double measured(double range) const;

  SamplePlacerOptions options_;
  TransformHistory transforms_;
  ros::Duration went_back_;  ///< how far the transforms' clock went back
  std::deque<Sample> waiting_;
  core::scan::ScanCloud cloud_;
  std::vector<core::scan::NoReturn> no_returns_;
  core::geometry::Vector3 beam_sum_ = core::geometry::Vector3::Zero();
  std::vector<core::scan::Dropped> dropped_;
  std::size_t samples_in_ = 0;
  ros::Time start_;
  ros::Time acknowledged_;
};

}  // namespace scan_to_path_ros
