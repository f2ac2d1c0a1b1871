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
/// beyond them. A controller that gives new counts at half the log's rate or less makes the log repeat each reading:
/// then the first of every such run counts, and at rest one in as many. Keeps references to what it was made from.
/// Reading it from several threads is safe.
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
  JointReadings(const JointReadings&) = delete;
  JointReadings& operator=(const JointReadings&) = delete;

  /// Joint angles [rad] at `time` on the encoders' clock [s], in the robot's order. On a reading it is that reading;
  /// between readings it is the Hermite cubic whose slopes at the readings are those of the parabola through the
  /// reading and its neighbours (Catmull-Rom on uneven times): exact for constant acceleration.
  /// `cursor` is where the search starts; kept by a caller whose times rise, it makes the search one step.
  Status anglesAt(double time, std::size_t& cursor, robot::JointVector& angles) const;

  std::size_t size() const { return size_; }

  /// How often the log repeats each reading; 1: it does not.
  std::size_t timesRepeated() const { return repeated_; }

  /// Of a reading, on the encoders' clock [s].
  double timeOf(std::size_t reading) const { return time_[reading]; }

  /// The reading's place among those of the log, repeated ones included.
  std::size_t placeInLog(std::size_t reading) const { return repeated_ == 1 ? reading : kept_[reading]; }

  /// Joint angles of a reading [rad], in the robot's order.
  robot::JointVector anglesOf(std::size_t reading) const;

private:
  struct Weights {
    double value[4];  ///< of the readings cursor - 1, cursor, cursor + 1, cursor + 2
  };

  void mapJoints(const robot::Robot& robot);
  void unwrap();
  void dropRepeated();
  const double* row(std::size_t reading) const { return counts_ + reading * column_.size(); }
  bool bracket(double time, std::size_t& cursor) const;
  Weights weightsAt(double time, std::size_t cursor) const;

  const scan::SampleLog& log_;
  const robot::Encoders& encoders_;
  double max_gap_;
  std::vector<std::size_t> column_;  ///< of the log, for each of the robot's joints
  std::vector<double> own_counts_;   ///< empty when no counter wraps and no reading is repeated
  std::vector<double> own_time_;     ///< empty when no reading is repeated
  std::vector<std::size_t> kept_;    ///< the same
  std::size_t repeated_ = 1;
  std::size_t size_;
  const double* counts_;
  const double* time_;
};

}  // namespace scan_to_path::sensing
