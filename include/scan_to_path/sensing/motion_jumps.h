// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/robot/robot.h"

namespace scan_to_path::sensing {

/// Coordinates that move together, up to eight, read again and again: a robot's joints, or the place of its sensor.
class MotionReadings {
public:
  virtual ~MotionReadings() = default;
  virtual std::size_t size() const = 0;
  virtual double timeOf(std::size_t reading) const = 0;  ///< [s], rising
  virtual robot::JointVector valuesOf(std::size_t reading) const = 0;
};

/// What the search for jumps asks. Lengths are in the coordinates' unit.
struct JumpLimits {
  double jump = 0.0;               ///< that motion does not explain
  double gap = 0.0;                ///< readings farther apart have a gap between them [s]
  std::vector<double> resolution;  ///< by which each coordinate's steps may be off
};

/// A step that motion does not explain.
struct MotionJump {
  std::size_t reading = 0;  ///< that it leads to
  int coordinate = 0;
  double step = 0.0;
  double low = 0.0;  ///< what motion explains
  double high = 0.0;
  double gap = 0.0;  ///< over which it goes [s]; 0: none
};

/// A jump that motion would have explained.
struct HiddenJump {
  std::size_t reading = 0;
  int coordinate = 0;
  double size = 0.0;
};

struct MotionJumps {
  std::optional<MotionJump> first;  ///< in order of time
  std::vector<HiddenJump> hidden;   ///< the largest of each coordinate in every 32768 readings, within 10 ms
  std::size_t pauses = 0;           ///< gaps between rests, with something elsewhere after them
};

/// Looks for steps that go by more than `limits.jump` beyond what the readings before and after explain (see
/// src/sensing/explained_step.h): from one reading to the next, over 2, 4, 8 … readings up to 10 ms, and over gaps
/// unless everything rests on both sides of one. Explained too are stamps that are half a millisecond off, or off in
/// any way between readings taken evenly, and the resolution. Over up to 0.13 s steps are looked at where all moves the
/// same way on both sides: speed may change there, but what is left beside the way is a jump. What takes longer, or
/// hides in a turn, looks like motion. The same for any number of threads. About 0.1 us for each reading of six
/// coordinates.
MotionJumps findMotionJumps(const MotionReadings& readings, const JumpLimits& limits, int threads = 1,
                            const Progress& progress = {});

}  // namespace scan_to_path::sensing
