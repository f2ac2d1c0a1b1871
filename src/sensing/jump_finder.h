// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "explained_step.h"
#include "joint_stretch.h"
#include "scan_to_path/sensing/joint_jumps.h"

namespace scan_to_path::sensing {

/// A step that motion does not explain.
struct Jump {
  std::size_t reading = 0;
  int joint = 0;
  double step = 0.0;  // [rad]
  ExplainedStep explained;
  double gap = 0.0;  // [s]; 0: none
};

/// A jump that motion would have explained.
struct Hidden {
  double angle = 0.0;  // [rad]
  std::size_t reading = 0;
};

/// Of some consecutive readings; `hidden` by joint.
struct BlockFindings {
  std::optional<Jump> jump;
  std::array<Hidden, robot::max_joints> hidden{};
  std::size_t pauses = 0;
};

/// Looks for jumps as joint_jumps.h says, in any stretch of the readings.
class JumpFinder {
public:
  JumpFinder(const JointReadings& readings, const JointJumpLimits& limits);

  /// The first jump that leads to one of the readings [begin, end), and what could hide there.
  BlockFindings find(std::size_t begin, std::size_t end) const;

private:
  enum class Clock { stamps, evenly };

  double resolution(int joint) const;
  double slack(int joint, const ExplainedStep& explained) const;
  bool goesOn(const JointStretch& stretch, std::size_t i, std::size_t stride, int joint) const;
  ExplainedStep explainedAround(const JointStretch& stretch, std::size_t i, std::size_t stride, int joint,
                                Clock clock) const;
  bool isEven(const JointStretch& stretch, std::size_t i, std::size_t stride) const;
  void lookAtStep(const JointStretch& stretch, std::size_t i, std::size_t stride, BlockFindings& found) const;
  SideReadings awayFromGap(std::size_t i, int joint, double spacing, bool forward) const;
  bool restsAround(std::size_t i) const;
  void lookAcrossGap(std::size_t i, BlockFindings& found) const;

  const JointReadings& readings_;
  const JointJumpLimits& limits_;
  double interval_;  // between readings [s]
  std::vector<std::size_t> strides_;
};

}  // namespace scan_to_path::sensing
