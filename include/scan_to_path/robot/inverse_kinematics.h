// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scan_to_path/robot/robot.h"

namespace scan_to_path::robot {

/// How far the closest try stayed from a pose.
struct Miss {
  double position = 0.0;  ///< [m]
  double rotation = 0.0;  ///< [rad]
};

/// Numerical inverse kinematics for any chain: a Newton iteration damped by its residual, from the seed and, when that
/// leads nowhere, from fixed starts. tests/benchmark/robot_benchmark.cpp has it beside KDL's solvers.
/// Every answer is checked by forward kinematics.
class InverseKinematics {
public:
  explicit InverseKinematics(const Robot& robot);
  ~InverseKinematics();
  InverseKinematics(InverseKinematics&&) noexcept;
  InverseKinematics& operator=(InverseKinematics&&) noexcept;

  /// Joint angles near `seed` that put the tip at T_base_tip within 0.1 um and 1e-7 rad. Angles may lie outside the
  /// limits (the caller says which, with a margin); whole turns are chosen nearest to the seed.
  /// Nothing when no solution is found (out of reach, or singular); `miss`, when not null, then says by how much.
  /// A seed that leads nowhere gives any configuration. Takes 2 us from a warm start, 0.5 ms out of reach.
  std::optional<JointVector> solve(const Frame& T_base_tip, const JointVector& seed, Miss* miss = nullptr) const;

  /// All distinct configurations within the limits of joints and coupled axis (shoulder, elbow, wrist; whole turns
  /// included, of a continuous joint only the one nearest 0, and of ranges of many turns at most 256 combinations,
  /// those nearest the middle), sorted by their distance from the middle of the joint ranges, found from 200 fixed
  /// starts: the same list every time, in about 2 ms. In a singular pose, or with more than six joints, solutions are
  /// not countable: the list then holds those that were found.
  std::vector<JointVector> allConfigurations(const Frame& T_base_tip) const;

private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace scan_to_path::robot
