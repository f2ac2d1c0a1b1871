// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/robot/robot.h"
#include "scan_to_path/scan/sample_log.h"
#include "scan_to_path/sensing/joint_readings.h"

namespace scan_to_path::sensing {

using geometry::Frame;
using geometry::Vector3;

/// The sensor at one instant, by the joints.
struct SensorPose {
  Vector3 origin = Vector3::Zero();  ///< in base_link [m]
  Vector3 beam = Vector3::UnitZ();   ///< unit
};

/// The sensor's pose at any time of a log.
class SensorMotion {
public:
  SensorMotion(const JointReadings& readings, const robot::Robot& robot, const Frame& T_tip_sensor)
      : readings_(readings), robot_(robot), T_tip_sensor_(T_tip_sensor) {}

  /// `time` on the encoders' clock [s]; false where the log has no joint readings. `cursor` as in JointReadings.
  bool poseAt(double time, std::size_t& cursor, SensorPose& pose) const;

private:
  const JointReadings& readings_;
  const robot::Robot& robot_;
  Frame T_tip_sensor_;
};

/// One sweep of the sensor to or fro: samples first … last - 1 of the log.
struct MotionRow {
  std::size_t first = 0;
  std::size_t last = 0;
  bool is_forward = true;  ///< towards +x of the row frame
  double across = 0.0;     ///< y in the row frame [m]
};

/// The rows of a raster, told from the sensor's motion alone.
struct RowMotion {
  Eigen::Matrix3d R_base_row = Eigen::Matrix3d::Identity();  ///< x along the rows, z against the mean beam
  std::vector<MotionRow> rows;                               ///< in order of time
};

/// Looks at about `looks` samples of the log, evenly spread. Rows are stretches of one sense of travel along the axis
/// of most of the motion, faster than half the median and at least half as long as the longest. No rows when the
/// sensor does not move.
RowMotion findRowMotion(const scan::SampleLog& log, const SensorMotion& motion, double clock_offset,
                        std::size_t looks = 40000);

}  // namespace scan_to_path::sensing
