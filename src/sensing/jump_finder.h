// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "explained_step.h"
#include "motion_stretch.h"
#include "scan_to_path/sensing/motion_jumps.h"

namespace scan_to_path::sensing {

/// Looks for jumps as motion_jumps.h says, in any stretch of the readings.
class JumpFinder {
public:
  JumpFinder(const MotionReadings& readings, const JumpLimits& limits);

  /// The first jump that leads to one of the readings [begin, end), and what could hide there.
  MotionJumps find(std::size_t begin, std::size_t end) const;

private:
  enum class Clock { stamps, evenly };
  struct Sides {
    SideReadings before;
    SideReadings after;
  };

  double slack(int coordinate, const ExplainedStep& explained) const;
  bool goesOn(const MotionStretch& stretch, std::size_t i, std::size_t stride) const;
  Sides sidesOf(const MotionStretch& stretch, std::size_t i, std::size_t stride, int coordinate, Clock clock) const;
  bool isEven(const MotionStretch& stretch, std::size_t i, std::size_t stride) const;
  void lookAtStep(const MotionStretch& stretch, std::size_t i, std::size_t stride, MotionJumps& found) const;
  bool isSteady(const MotionStretch& stretch, std::size_t i, std::size_t stride) const;
  void lookBesideThePath(const MotionStretch& stretch, std::size_t i, std::size_t stride, MotionJumps& found) const;
  SideReadings awayFromGap(std::size_t i, int coordinate, double spacing, bool forward) const;
  bool restsAround(std::size_t i) const;
  void lookAcrossGap(std::size_t i, MotionJumps& found) const;

  const MotionReadings& readings_;
  const JumpLimits& limits_;
  double interval_;                        // between readings [s]
  std::vector<std::size_t> strides_;       // of slips that no motion looks like
  std::vector<std::size_t> long_strides_;  // of those that leave the path
};

}  // namespace scan_to_path::sensing
