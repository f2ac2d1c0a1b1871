// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/sample_placer.h"

#include <pcl_conversions/pcl_conversions.h>
#include <tf2/exceptions.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"

namespace scan_to_path_ros {
namespace {

using core::InputError;
using core::geometry::Frame;
using core::geometry::Vector3;

/// Seconds on a grid of nanoseconds, so that the same instant is the same number however it came.
double onGrid(double seconds) { return std::round(seconds * 1e9) / 1e9; }

void check(const core::ScanSamples& samples, const std::string& frame) {
  if (samples.header.frame_id != frame) {
    throw InputError("scan samples", "frame_id", "'" + samples.header.frame_id + "'", "'" + frame + "'");
  }
  if (samples.time_offset.size() != samples.range.size()) {
    throw InputError("scan samples: " + std::to_string(samples.time_offset.size()) + " time offsets and " +
                     std::to_string(samples.range.size()) + " ranges, must be as many");
  }
  double last = -1e-9;
  for (std::size_t i = 0; i < samples.time_offset.size(); ++i) {
    const double offset = samples.time_offset[i];
    if (!(std::isfinite(offset) && offset > last)) {
      throw InputError("scan samples", "time_offset[" + std::to_string(i) + "]", std::to_string(offset) + " s",
                       "finite, not negative and rising");
    }
    last = offset;
  }
}

}  // namespace

SamplePlacer::SamplePlacer(const SamplePlacerOptions& options)
    : options_(options), buffer_(ros::Duration(options.cache)) {
  restart(options);
}

void SamplePlacer::restart(const SamplePlacerOptions& options) {
  options_ = options;
  waiting_.clear();
  dropped_.clear();
  samples_in_ = 0;
  beam_sum_ = Vector3::Zero();
  start_ = acknowledged_ = ros::Time();
  cloud_ = core::scan::ScanCloud();
  cloud_.header.frame_id = options_.base_frame;
  cloud_.height = 1;
}

void SamplePlacer::addTransform(const geometry_msgs::TransformStamped& transform, bool is_static) {
  if (!buffer_.setTransform(transform, "tf", is_static) || is_static) return;
  auto& stamps = stamps_[transform.child_frame_id];
  const ros::Time stamp = transform.header.stamp;
  stamps.insert(std::upper_bound(stamps.begin(), stamps.end(), stamp), stamp);
  while (stamps.back() - stamps.front() > ros::Duration(options_.cache)) stamps.pop_front();
  placeWaiting();
}

void SamplePlacer::addSamples(const core::ScanSamples& samples) {
  check(samples, options_.sensor_frame);
  if (samples.range.empty()) return;
  if (start_.isZero()) start_ = samples.header.stamp + ros::Duration(samples.time_offset.front());
  const ros::Time first = samples.header.stamp + ros::Duration(samples.time_offset.front());
  const ros::Time last = waiting_.empty() ? acknowledged_ : waiting_.back().stamp;
  if (!last.isZero() && first <= last) {
    throw InputError("scan samples: stamp " + std::to_string(first.toSec()) + " s is not after the last sample's " +
                     std::to_string(last.toSec()) + " s");
  }
  for (std::size_t i = 0; i < samples.range.size(); ++i) {
    const ros::Time stamp = samples.header.stamp + ros::Duration(samples.time_offset[i]);
    waiting_.push_back({stamp, onGrid((stamp - start_).toSec()), samples.range[i]});
  }
  samples_in_ += samples.range.size();
  placeWaiting();
}

void SamplePlacer::finish() {
  placeWaiting();
  for (; !waiting_.empty(); waiting_.pop_front()) {
    drop("no transform");
    acknowledged_ = waiting_.front().stamp;
  }
}

void SamplePlacer::placeWaiting() {
  while (!waiting_.empty() && place(waiting_.front()) == Outcome::done) {
    acknowledged_ = waiting_.front().stamp;
    waiting_.pop_front();
  }
}

SamplePlacer::Outcome SamplePlacer::place(const Sample& sample) {
  if (!std::isfinite(sample.range)) {
    drop(std::isnan(sample.range) ? "sensor fault" : "no return");  // REP 117
    return Outcome::done;
  }
  if (moving_frame_.empty()) findMovingFrame();
  const ros::Time stamp = sample.stamp + ros::Duration(options_.clock_offset);
  const auto stamps = stamps_.find(moving_frame_);
  if (stamps == stamps_.end() || stamps->second.back() < stamp) {
    if (waiting_.back().stamp - sample.stamp <= ros::Duration(options_.max_wait)) return Outcome::later;
    drop("no transform");
  } else if (stamp < stamps->second.front()) {
    drop("no joint reading");
  } else if (isInGap(stamp)) {
    drop("joint readings too far apart");
  } else {
    addPoint(sample, stamp);
  }
  return Outcome::done;
}

void SamplePlacer::addPoint(const Sample& sample, const ros::Time& stamp) {
  try {
    const Frame T = tf2::transformToEigen(buffer_.lookupTransform(options_.base_frame, options_.sensor_frame, stamp));
    const Vector3 beam = T.linear().col(2);
    const Vector3 point = T.translation() + sample.range * beam;  // Equation (2)
    core::scan::ScanPoint target;
    target.getVector4fMap() << point.cast<float>(), 1.0F;
    target.line = core::scan::no_line;
    target.time = sample.time;
    cloud_.points.push_back(target);
    beam_sum_ += beam;
  } catch (const tf2::TransformException&) {
    drop("no transform");
  }
}

void SamplePlacer::drop(const char* reason) { core::scan::addDropped(dropped_, reason, 1); }

bool SamplePlacer::isInGap(const ros::Time& stamp) const {
  const auto& stamps = stamps_.at(moving_frame_);
  const auto after = std::lower_bound(stamps.begin(), stamps.end(), stamp);
  if (after == stamps.begin() || *after == stamp) return false;
  return *after - *std::prev(after) > ros::Duration(options_.max_joint_gap);
}

void SamplePlacer::findMovingFrame() {
  std::string frame = options_.sensor_frame;
  std::string parent;
  while (frame != options_.base_frame) {
    if (stamps_.count(frame) > 0) {
      moving_frame_ = frame;
      return;
    }
    if (!buffer_._getParent(frame, ros::Time(), parent)) return;
    frame = parent;
  }
}

core::pipeline::ScanStage SamplePlacer::take() {
  if (cloud_.points.empty()) {
    std::string message = "scan: none of " + std::to_string(samples_in_) + " samples could be placed";
    for (const auto& entry : dropped_) message += ", " + std::to_string(entry.count) + " " + entry.reason;
    throw InputError(message);
  }
  core::pipeline::ScanStage stage;
  cloud_.width = static_cast<std::uint32_t>(cloud_.points.size());
  pcl_conversions::toPCL(start_, cloud_.header.stamp);
  stage.report = {"scan", samples_in_, cloud_.points.size(), dropped_};
  stage.mean_beam = core::geometry::roundedDirection(beam_sum_);
  stage.cloud = std::move(cloud_);
  restart(options_);
  return stage;
}

}  // namespace scan_to_path_ros
