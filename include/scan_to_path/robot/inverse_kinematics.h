// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scan_to_path/robot/robot.h"

namespace scan_to_path::robot {

/// Inverse kinematics by KDL: Newton-Raphson with joint limits from a warm start, Levenberg-Marquardt when that fails.
/// Every answer is checked by this project's own forward kinematics. One object per thread.
class InverseKinematics {
public:
  explicit InverseKinematics(const Robot& robot);
  ~InverseKinematics();
  InverseKinematics(InverseKinematics&&) noexcept;
  InverseKinematics& operator=(InverseKinematics&&) noexcept;

  /// Joint angles near `seed` that put the tip at T_base_tip within 0.1 um and 1e-7 rad. Angles may lie outside the
  /// limits (the caller says which, with a margin); whole turns are chosen nearest to the seed.
  /// Nothing when no solution is found (out of reach, or singular).
  std::optional<JointVector> solve(const Frame& T_base_tip, const JointVector& seed) const;

  /// All distinct configurations within joint limits (shoulder, elbow, wrist; whole turns included), sorted by their
  /// distance from the middle of the joint ranges, found from a fixed set of starts: the same list every time.
  std::vector<JointVector> allConfigurations(const Frame& T_base_tip) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scan_to_path::robot
