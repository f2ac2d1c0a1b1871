// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/sensor_track.h"

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path_ros {

namespace core = scan_to_path;
using core::geometry::Vector3;

namespace {

const Vector3 ahead_of_sensor(0.0, 0.0, 0.1);  // [m]
constexpr double resolution = 4e-6;            // [m]; four encoder counts of 0.5 urad, a metre from the axis

}  // namespace

SensorPlace placeOf(const ros::Time& stamp, const core::geometry::Frame& T_base_sensor) {
  return {stamp, T_base_sensor.translation(), T_base_sensor * ahead_of_sensor};
}

bool isReached(const SensorPlace& from, const SensorPlace& to, double max_speed) {
  return (to.ahead - from.ahead).norm() <= max_speed * (to.stamp - from.stamp).toSec();
}

void SensorTrack::add(const SensorPlace& place, double max_speed) {
  if (places_.empty() || isReached(places_.back(), place, max_speed)) places_.push_back(place);
}

double SensorTrack::timeOf(std::size_t reading) const {
  return (places_[reading].stamp - places_.front().stamp).toSec();
}

core::robot::JointVector SensorTrack::valuesOf(std::size_t reading) const {
  core::robot::JointVector values(6);
  values << places_[reading].origin, places_[reading].ahead;
  return values;
}

core::sensing::UnseenJumps checkSensorJumps(const SensorTrack& track, double max_joint_jump, double max_gap) {
  if (max_joint_jump <= 0.0 || track.size() == 0) return {};
  const double reach = track.valuesOf(0).head<3>().norm();
  const double limit = max_joint_jump * reach;
  const auto jumps = core::sensing::findMotionJumps(track, {limit, max_gap, std::vector<double>(6, resolution)});
  if (jumps.first) {
    const auto& jump = *jumps.first;
    throw core::InputError(
        "scan: the sensor jumps by " + core::fixed(1e3 * jump.step, 3) + " mm along " + "xyz"[jump.coordinate % 3] +
        " of the base at " + core::fixed(track.timeOf(jump.reading), 3) + " s" +
        (jump.gap > 0.0 ? " over a gap of " + core::fixed(jump.gap, 3) + " s in the transforms" : "") +
        ", its motion before and after explains " + core::fixed(1e3 * jump.low, 3) + " to " +
        core::fixed(1e3 * jump.high, 3) + " mm (limit " + core::fixed(1e3 * limit, 3) +
        " mm beyond, scan.placement.max_joint_jump): lost counts, a slipped coupling or a bad reading");
  }
  core::sensing::UnseenJumps unseen;
  unseen.pauses = jumps.pauses;
  for (const auto& hidden : jumps.hidden) {
    if (hidden.size <= unseen.distance) continue;
    unseen.distance = hidden.size;
    unseen.what = "the sensor";
    unseen.time = track.timeOf(hidden.reading);
  }
  return unseen;
}

}  // namespace scan_to_path_ros
