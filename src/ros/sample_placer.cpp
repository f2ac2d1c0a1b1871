// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/sample_placer.h"

#include <pcl_conversions/pcl_conversions.h>
#include <tf2/exceptions.h>

#include <cmath>
#include <limits>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/pipeline/joint_findings.h"

namespace scan_to_path_ros {
namespace {

using core::InputError;
using core::geometry::Frame;
using core::geometry::Vector3;

constexpr const char* no_return = "no return";

/// Seconds on a grid of nanoseconds, so that the same instant is the same number however it came.
double onGrid(double seconds) { return std::round(seconds * 1e9) / 1e9; }

void checkOffsets(const std::vector<double>& offsets) {
  double last = -1e-9;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (!(std::isfinite(offsets[i]) && offsets[i] > last)) {
      throw InputError("scan samples", "time_offset[" + std::to_string(i) + "]", std::to_string(offsets[i]) + " s",
                       "finite, not negative and rising");
    }
    last = offsets[i];
  }
}

}  // namespace

SamplePlacer::SamplePlacer(const SamplePlacerOptions& options) : options_(options), transforms_(options) {
  restart(options);
}

void SamplePlacer::restart(const SamplePlacerOptions& options) {
  options_ = options;
  transforms_.setOptions(options);
  waiting_.clear();
  dropped_.clear();
  samples_in_ = 0;
  beam_sum_ = Vector3::Zero();
  start_ = acknowledged_ = ros::Time();
  went_back_ = ros::Duration();
  cloud_ = core::scan::ScanCloud();
  no_returns_.clear();
  cloud_.header.frame_id = options_.base_frame;
  cloud_.height = 1;
}

void SamplePlacer::addTransform(const geometry_msgs::TransformStamped& transform, bool is_static) {
  const ros::Duration went_back = transforms_.add(transform, is_static);
  if (!went_back.isZero()) {
    went_back_ = went_back;
    giveUp("clock went back");
  }
  placeWaiting();
}

void SamplePlacer::check(const core::ScanSamples& samples) const {
  if (samples.header.frame_id != options_.sensor_frame) {
    throw InputError("scan samples", "frame_id", "'" + samples.header.frame_id + "'",
                     "'" + options_.sensor_frame + "'");
  }
  if (samples.time_offset.size() != samples.range.size()) {
    throw InputError("scan samples: " + std::to_string(samples.time_offset.size()) + " time offsets and " +
                     std::to_string(samples.range.size()) + " ranges, must be as many");
  }
  checkOffsets(samples.time_offset);
  if (samples.range.empty()) return;
  const ros::Time first = samples.header.stamp + ros::Duration(samples.time_offset.front());
  const ros::Time last = waiting_.empty() ? acknowledged_ : waiting_.back().stamp;
  if (!last.isZero() && first <= last) {
    throw InputError("scan samples: stamp " + core::fixed(first.toSec(), 6) + " s is not after the last sample's " +
                     core::fixed(last.toSec(), 6) + " s");
  }
}

void SamplePlacer::addSamples(const core::ScanSamples& samples) {
  samples_in_ += samples.range.size();
  try {
    check(samples);
  } catch (const InputError&) {
    core::scan::addDropped(dropped_, "refused", samples.range.size());
    throw;
  }
  if (samples.range.empty()) return;
  if (start_.isZero()) start_ = samples.header.stamp + ros::Duration(samples.time_offset.front());
  for (std::size_t i = 0; i < samples.range.size(); ++i) {
    const ros::Time stamp = samples.header.stamp + ros::Duration(samples.time_offset[i]);
    waiting_.push_back({stamp, onGrid((stamp - start_).toSec()), measured(samples.range[i])});
  }
  placeWaiting();
}

/// What a sensor says that rests at the end of its range is as little a measurement as what it says beyond it.
double SamplePlacer::measured(double range) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (range < options_.range_min) return -infinity;
  return range > options_.range_max ? infinity : range;
}

void SamplePlacer::finish() {
  placeWaiting();
  giveUp("no transform");
}

void SamplePlacer::giveUp(const char* reason) {
  for (; !waiting_.empty(); waiting_.pop_front()) {
    leaveOut(waiting_.front(), reason);
    acknowledged_ = waiting_.front().stamp;
  }
}

void SamplePlacer::placeWaiting() {
  while (!waiting_.empty() && place(waiting_.front()) == Outcome::done) {
    acknowledged_ = waiting_.front().stamp;
    waiting_.pop_front();
  }
  if (!acknowledged_.isZero()) transforms_.follow(followed() - ros::Duration(options_.max_disorder));
}

ros::Time SamplePlacer::followed() const { return acknowledged_ + ros::Duration(options_.clock_offset); }

SamplePlacer::Outcome SamplePlacer::place(const Sample& sample) {
  using Reach = TransformHistory::Reach;
  const ros::Time stamp = sample.stamp + ros::Duration(options_.clock_offset);
  switch (transforms_.reach(stamp)) {
    case Reach::not_yet:
      if (waiting_.back().stamp - sample.stamp <= ros::Duration(options_.max_wait)) return Outcome::later;
      leaveOut(sample, "no transform");
      break;
    case Reach::before_first:
      leaveOut(sample, "no joint reading");
      break;
    case Reach::gap:
      leaveOut(sample, "joint readings too far apart");
      break;
    case Reach::jump:
      leaveOut(sample, "transform jumps");
      break;
    case Reach::known:
      addSample(sample, stamp);
      break;
  }
  return Outcome::done;
}

void SamplePlacer::addSample(const Sample& sample, const ros::Time& stamp) {
  const bool has_return = std::isfinite(sample.range);
  try {
    const Frame T = transforms_.sensorAt(stamp);
    if (has_return) {
      addPoint(sample, T);
      return;
    }
    const Vector3 far_end = T.translation() + options_.range_max * T.linear().col(2);
    no_returns_.push_back({far_end.cast<float>(), std::isnan(sample.range) || sample.range < 0.0});
    leaveOut(sample, no_return);
  } catch (const tf2::TransformException&) {
    leaveOut(sample, "no transform");
  }
}

void SamplePlacer::addPoint(const Sample& sample, const Frame& T_base_sensor) {
  const Vector3 beam = T_base_sensor.linear().col(2);
  const Vector3 point = T_base_sensor.translation() + sample.range * beam;  // Equation (2)
  core::scan::ScanPoint target;
  target.getVector4fMap() << point.cast<float>(), 1.0F;
  target.line = core::scan::no_line;
  target.time = sample.time;
  cloud_.points.push_back(target);
  beam_sum_ += beam;
}

/// A beam without a return, or a fault (REP 117), is none wherever it went: that is the reason for which there is no
/// point of it.
void SamplePlacer::leaveOut(const Sample& sample, const char* reason) {
  if (std::isnan(sample.range)) reason = "sensor fault";
  core::scan::addDropped(dropped_, std::isinf(sample.range) ? no_return : reason, 1);
}

core::pipeline::ScanStage SamplePlacer::take() {
  if (!went_back_.isZero()) {
    throw InputError("scan: the clock of the transforms went back by " + core::fixed(went_back_.toSec(), 3) +
                     " s on the way; scan again");
  }
  if (cloud_.points.empty()) {
    std::string message = "scan: none of " + std::to_string(samples_in_) + " samples could be placed";
    for (const auto& entry : dropped_) message += ", " + std::to_string(entry.count) + " " + entry.reason;
    throw InputError(message);
  }
  transforms_.follow(followed());
  const auto unseen = checkSensorJumps(transforms_.track(), options_.max_joint_jump, options_.max_joint_gap);
  core::pipeline::JointFindings joints = core::pipeline::jointFindings(unseen, 1, options_.limits);
  core::pipeline::ScanStage stage;
  stage.accuracy = std::move(joints.accuracy);
  stage.notes = std::move(joints.notes);
  cloud_.width = static_cast<std::uint32_t>(cloud_.points.size());
  pcl_conversions::toPCL(start_, cloud_.header.stamp);
  stage.report = {"scan", samples_in_, cloud_.points.size(), dropped_};
  stage.mean_beam = core::geometry::roundedDirection(beam_sum_);
  stage.cloud = std::make_shared<const core::scan::ScanCloud>(std::move(cloud_));
  stage.no_returns = {std::move(no_returns_), options_.range_max - options_.range_min, options_.range_min};
  restart(options_);
  return stage;
}

}  // namespace scan_to_path_ros
