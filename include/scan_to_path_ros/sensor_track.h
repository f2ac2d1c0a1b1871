// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/time.h>

#include <string>
#include <vector>

#include "scan_to_path/geometry/frames.h"
#include "scan_to_path/sensing/joint_jumps.h"
#include "scan_to_path/sensing/motion_jumps.h"

namespace scan_to_path_ros {

/// Where the sensor is at a reading: its origin and a point before it, so that what only turns it shows as well.
struct SensorPlace {
  ros::Time stamp;
  scan_to_path::geometry::Vector3 origin = scan_to_path::geometry::Vector3::Zero();  ///< in base [m]
  scan_to_path::geometry::Vector3 ahead = scan_to_path::geometry::Vector3::Zero();   ///< in base [m]
};

SensorPlace placeOf(const ros::Time& stamp, const scan_to_path::geometry::Frame& T_base_sensor);

/// Whether a sensor of at most `max_speed` [m/s] gets from one place to the other.
bool isReached(const SensorPlace& from, const SensorPlace& to, double max_speed);

/// Where the sensor was at each reading of a scan.
class SensorTrack : public scan_to_path::sensing::MotionReadings {
public:
  /// Leaves out what could only be reached from the last place faster than `max_speed` [m/s].
  void add(const SensorPlace& place, double max_speed);
  void clear() { places_.clear(); }
  ros::Time end() const { return places_.back().stamp; }  ///< of the last reading; needs one

  std::size_t size() const override { return places_.size(); }
  double timeOf(std::size_t reading) const override;                              ///< [s] from the first
  scan_to_path::robot::JointVector valuesOf(std::size_t reading) const override;  ///< x, y, z of both points [m]

private:
  std::vector<SensorPlace> places_;
};

/// Throws InputError where the sensor's motion does not explain a step (motion_jumps.h): a robot that slipped or lost
/// counts carries it elsewhere from then on. The limit is what a turn of `max_joint_jump` [rad] about the base would
/// move the sensor; 0: none. Readings more than `max_gap` [s] apart have a gap between them.
scan_to_path::sensing::UnseenJumps checkSensorJumps(const SensorTrack& track, double max_joint_jump, double max_gap);

}  // namespace scan_to_path_ros
