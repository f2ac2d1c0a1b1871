// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/robot/encoders.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/scan/sample_log.h"

namespace scan_to_path::sensing {

/// The joint readings of a sample log as a function of time: counter wraps undone, cubic between readings, nothing
/// beyond them. Keeps references to what it was made from. Reading it from several threads is safe.
class JointReadings {
public:
  enum class Status {
    found,
    outside,  ///< before the first reading or after the last
    gap,      ///< between readings more than max_gap apart
  };

  /// `max_gap` [s]. Throws InputError when the log's joints are not the robot's (any order), naming the joint, when
  /// a reading is not finite or times do not rise, naming the reading.
  JointReadings(const scan::SampleLog& log, const robot::Robot& robot, const robot::Encoders& encoders, double max_gap);

  /// Joint angles [rad] at `time` on the encoders' clock [s], in the robot's order. On a reading it is that reading;
  /// between readings it is the Hermite cubic whose slopes at the readings are those of the parabola through the
  /// reading and its neighbours (Catmull-Rom on uneven times): exact for constant acceleration.
  /// `cursor` is where the search starts; kept by a caller whose times rise, it makes the search one step.
  Status anglesAt(double time, std::size_t& cursor, robot::JointVector& angles) const;

  std::size_t size() const { return log_.joint_time.size(); }

  /// Of a reading, on the encoders' clock [s].
  double timeOf(std::size_t reading) const { return log_.joint_time[reading]; }

  /// Joint angles of a reading [rad], in the robot's order.
  robot::JointVector anglesOf(std::size_t reading) const;

private:
  struct Weights {
    double value[4];  ///< of the readings cursor - 1, cursor, cursor + 1, cursor + 2
  };

  void mapJoints(const robot::Robot& robot);
  void unwrap();
  const double* row(std::size_t reading) const { return counts_ + reading * column_.size(); }
  bool bracket(double time, std::size_t& cursor) const;
  Weights weightsAt(double time, std::size_t cursor) const;

  const scan::SampleLog& log_;
  const robot::Encoders& encoders_;
  double max_gap_;
  std::vector<std::size_t> column_;  ///< of the log, for each of the robot's joints
  std::vector<double> unwrapped_;    ///< empty when no counter wraps
  const double* counts_;
};

}  // namespace scan_to_path::sensing
