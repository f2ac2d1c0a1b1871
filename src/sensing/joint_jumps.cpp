// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/joint_jumps.h"

#include <algorithm>

#include "jump_finder.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/parallel.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {
namespace {

constexpr std::size_t readings_at_a_time = 8192;  // fixed, so that blocks do not depend on threads

[[noreturn]] void throwJump(const JointReadings& readings, const robot::Robot& robot, const Jump& jump, double limit) {
  const std::string gap = jump.gap > 0.0 ? " over a gap of " + fixed(jump.gap, 3) + " s in the readings" : "";
  throw InputError(
      "joint reading " + std::to_string(readings.placeInLog(jump.reading)) + " at " +
      fixed(readings.timeOf(jump.reading), 6) + " s: " + robot.joints[static_cast<std::size_t>(jump.joint)].name +
      " jumps by " + fixed(jump.step, 6) + " rad" + gap + ", its motion before and after explains " +
      fixed(jump.explained.low, 6) + " to " + fixed(jump.explained.high, 6) + " rad (limit " + fixed(limit, 6) +
      " rad beyond, scan.placement.max_joint_jump): lost counts, a slipped coupling, a new home position " +
      (jump.gap > 0.0 ? "or motion that nobody saw" : "or a bad reading"));
}

/// How far a turn of one joint moves the spot [m/rad].
double leverOf(const robot::Robot& robot, const robot::JointVector& angles, const geometry::Vector3& spot_tip,
               int joint) {
  const auto columns = robot::jacobian(robot, angles);
  const geometry::Vector3 linear = columns.col(joint).head<3>(), angular = columns.col(joint).tail<3>();
  const geometry::Vector3 from_tip = robot::forwardKinematics(robot, angles).linear() * spot_tip;
  return (linear + angular.cross(from_tip)).norm();
}

UnseenJumps unseenJumps(const std::vector<BlockFindings>& blocks, const JointReadings& readings,
                        const robot::Robot& robot, const geometry::Vector3& spot_tip) {
  UnseenJumps unseen;
  for (const auto& block : blocks) {
    unseen.pauses += block.pauses;
    for (int joint = 0; joint < robot.dof(); ++joint) {
      const Hidden& hidden = block.hidden[static_cast<std::size_t>(joint)];
      if (hidden.angle <= 0.0) continue;
      const double distance = hidden.angle * leverOf(robot, readings.anglesOf(hidden.reading), spot_tip, joint);
      if (distance <= unseen.distance) continue;
      unseen.angle = hidden.angle;
      unseen.distance = distance;
      unseen.joint = joint;
      unseen.time = readings.timeOf(hidden.reading);
    }
  }
  return unseen;
}

}  // namespace

UnseenJumps checkJointJumps(const JointReadings& readings, const robot::Robot& robot, const geometry::Vector3& spot_tip,
                            const JointJumpLimits& limits, int threads, const Progress& progress) {
  if (readings.size() < 2) return {};
  const JumpFinder finder(readings, limits);
  std::vector<BlockFindings> blocks((readings.size() + readings_at_a_time - 1) / readings_at_a_time);
  parallelFor(blocks.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      progress.checkCancelled();
      blocks[b] = finder.find(b * readings_at_a_time, std::min(readings.size(), (b + 1) * readings_at_a_time));
    }
  });
  for (const auto& block : blocks) {
    if (block.jump) throwJump(readings, robot, *block.jump, limits.jump);
  }
  return unseenJumps(blocks, readings, robot, spot_tip);
}

}  // namespace scan_to_path::sensing
