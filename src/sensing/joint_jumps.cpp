// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/joint_jumps.h"

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/sensing/motion_jumps.h"

namespace scan_to_path::sensing {
namespace {

constexpr double counts_off = 4.0;             // both readings by one and a half, and rounding
constexpr std::size_t fewest_readings = 1000;  // of a scan, not of a few places that a robot was at

class JointAngles : public MotionReadings {
public:
  explicit JointAngles(const JointReadings& readings) : readings_(readings) {}
  std::size_t size() const override { return readings_.size(); }
  double timeOf(std::size_t reading) const override { return readings_.timeOf(reading); }
  robot::JointVector valuesOf(std::size_t reading) const override { return readings_.anglesOf(reading); }

private:
  const JointReadings& readings_;
};

[[noreturn]] void throwJump(const JointReadings& readings, const robot::Robot& robot, const MotionJump& jump,
                            double limit) {
  const std::string gap = jump.gap > 0.0 ? " over a gap of " + fixed(jump.gap, 3) + " s in the readings" : "";
  throw InputError(
      "joint reading " + std::to_string(readings.placeInLog(jump.reading)) + " at " +
      fixed(readings.timeOf(jump.reading), 6) + " s: " + robot.joints[static_cast<std::size_t>(jump.coordinate)].name +
      " jumps by " + fixed(jump.step, 6) + " rad" + gap + ", its motion before and after explains " +
      fixed(jump.low, 6) + " to " + fixed(jump.high, 6) + " rad (limit " + fixed(limit, 6) +
      " rad beyond, scan.placement.max_joint_jump): lost counts, a slipped coupling, a new home position " +
      (jump.gap > 0.0 ? "or motion that nobody saw" : "or a bad reading"));
}

/// Readings that are all farther apart than a gap show no motion to judge by.
void checkInterval(const JointReadings& readings, double gap) {
  if (readings.size() < fewest_readings) return;
  std::size_t far = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) far += readings.timeOf(i) - readings.timeOf(i - 1) > gap ? 1 : 0;
  if (2 * far < readings.size()) return;
  throw InputError("joint readings: " + std::to_string(far) + " of " + std::to_string(readings.size() - 1) +
                   " intervals are longer than " + fixed(gap, 3) +
                   " s (scan.placement.max_joint_gap); times are in seconds: are these milliseconds?");
}

/// How far a turn of one joint moves the spot [m/rad].
double leverOf(const robot::Robot& robot, const robot::JointVector& angles, const geometry::Vector3& spot_tip,
               int joint) {
  const auto columns = robot::jacobian(robot, angles);
  const geometry::Vector3 linear = columns.col(joint).head<3>(), angular = columns.col(joint).tail<3>();
  const geometry::Vector3 from_tip = robot::forwardKinematics(robot, angles).linear() * spot_tip;
  return (linear + angular.cross(from_tip)).norm();
}

UnseenJumps unseenJumps(const MotionJumps& jumps, const JointReadings& readings, const robot::Robot& robot,
                        const geometry::Vector3& spot_tip) {
  UnseenJumps unseen;
  unseen.pauses = jumps.pauses;
  for (const auto& hidden : jumps.hidden) {
    const double lever = leverOf(robot, readings.anglesOf(hidden.reading), spot_tip, hidden.coordinate);
    if (hidden.size * lever <= unseen.distance) continue;
    unseen.angle = hidden.size;
    unseen.distance = hidden.size * lever;
    unseen.what =
        robot.joints[static_cast<std::size_t>(hidden.coordinate)].name + " by up to " + fixed(hidden.size, 6) + " rad";
    unseen.time = readings.timeOf(hidden.reading);
  }
  return unseen;
}

}  // namespace

UnseenJumps checkJointJumps(const JointReadings& readings, const robot::Robot& robot, const geometry::Vector3& spot_tip,
                            const JointJumpLimits& limits, int threads, const Progress& progress) {
  checkInterval(readings, limits.gap);
  JumpLimits turns{limits.jump, limits.gap, limits.one_count};
  for (double& resolution : turns.resolution) resolution *= counts_off;
  const MotionJumps jumps = findMotionJumps(JointAngles(readings), turns, threads, progress);
  if (jumps.first) throwJump(readings, robot, *jumps.first, limits.jump);
  return unseenJumps(jumps, readings, robot, spot_tip);
}

}  // namespace scan_to_path::sensing
