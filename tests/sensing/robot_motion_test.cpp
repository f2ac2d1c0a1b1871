// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/robot_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/robot/inverse_kinematics.h"
#include "support/expect_input_error.h"
#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

using test::SensingCell;

RasterPlan planOf(const SensingCell& cell, const RasterOptions& options = {}) {
  return planRaster(cell.rectangle, options);
}

RobotMotion motionOf(const SensingCell& cell, const RasterPlan& plan) {
  return {plan, cell.robot, cell.T_base_workpiece, cell.T_tip_sensor};
}

/// Largest distance of the sensor from its straight line, and largest turn from its fixed orientation.
struct Departure {
  double position = 0.0;  // [m]
  double rotation = 0.0;  // [rad]
};

Departure largestDeparture(const SensingCell& cell, const RasterPlan& plan) {
  const RobotMotion motion = motionOf(cell, plan);
  Departure largest;
  Random random(21);
  for (std::size_t m = 0; m < plan.moves.size(); ++m) {
    const RasterMove& move = plan.moves[m];
    const double length = (move.to - move.from).norm();
    for (int i = 0; i <= 50; ++i) {
      const double share = i == 0 ? 0.0 : i == 50 ? 1.0 : random.uniform();
      const auto q = motion.jointsAt(m, share * length);
      const Frame T = cell.T_base_workpiece.inverse() * robot::forwardKinematics(cell.robot, q) * cell.T_tip_sensor;
      const Vector3 expected = move.from + share * (move.to - move.from);
      largest.position = std::max(largest.position, (T.translation() - expected).norm());
      largest.rotation = std::max(largest.rotation, geometry::rotationAngle(T.linear(), plan.R_workpiece_sensor));
    }
  }
  return largest;
}

TEST(RobotMotion, KeepsTheRasterToANanometre) {
  for (const double angle : {0.0, 0.6, M_PI_2}) {
    RasterOptions options;
    options.row_angle = angle;
    options.pitch = 0.01;
    const SensingCell cell;
    const Departure departure = largestDeparture(cell, planOf(cell, options));
    EXPECT_LT(departure.position, 1e-9) << angle;
    EXPECT_LT(departure.rotation, 1e-9) << angle;
  }
}

TEST(RobotMotion, AgreesWithInverseKinematicsAtEveryTick) {
  const SensingCell cell = SensingCell::small();
  const RasterPlan plan = planOf(cell);
  const RobotMotion motion = motionOf(cell, plan);
  const robot::InverseKinematics ik(cell.robot);
  robot::JointVector seed = motion.jointsAt(0, 0.0);
  Frame T_workpiece_sensor = Frame::Identity();
  T_workpiece_sensor.linear() = plan.R_workpiece_sensor;
  for (double distance = 0.0; distance < 0.25; distance += 0.00005) {
    T_workpiece_sensor.translation() = plan.moves[0].from + distance * Vector3::UnitX();
    const auto q = ik.solve(cell.T_base_workpiece * T_workpiece_sensor * cell.T_tip_sensor.inverse(), seed);
    ASSERT_TRUE(q);
    // The solver stops at 0.1 um and 0.1 urad of the tip; joints turn by at most a few times that.
    EXPECT_LT((*q - motion.jointsAt(0, distance)).cwiseAbs().maxCoeff(), 1e-6);
    seed = *q;
  }
}

TEST(RobotMotion, MovesMeetWithoutAJump) {
  const SensingCell cell = SensingCell::small();
  const RasterPlan plan = planOf(cell);
  const RobotMotion motion = motionOf(cell, plan);
  for (std::size_t m = 0; m + 1 < plan.moves.size(); ++m) {
    const double length = (plan.moves[m].to - plan.moves[m].from).norm();
    EXPECT_LT((motion.jointsAt(m, length) - motion.jointsAt(m + 1, 0.0)).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(RobotMotion, HalfAMetreIsWithinReach) {
  SensingCell cell;
  cell.T_base_workpiece = geometry::makeFrame({0.75, -0.25, 0.45}, Vector3::Zero());
  cell.rectangle = {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.5, 0.5)};
  RasterOptions options;
  options.pitch = 0.05;
  EXPECT_NO_THROW(motionOf(cell, planOf(cell, options)));
}

TEST(RobotMotion, AnotherConfigurationIsTakenWhenTheFirstFails) {
  SensingCell cell = SensingCell::small();
  const RasterPlan plan = planOf(cell);
  const double natural = motionOf(cell, plan).jointsAt(0, 0.0)[4];
  // Forbid the wrist that way round: the flipped wrist is left.
  (natural > 0.0 ? cell.robot.joints[4].upper : cell.robot.joints[4].lower) = 0.0;
  EXPECT_LT(motionOf(cell, plan).jointsAt(0, 0.0)[4] * natural, 0.0);
}

TEST(RobotMotion, UnreachableRastersAreNamed) {
  SensingCell cell;
  const RasterPlan plan = planOf(cell);
  cell.T_base_workpiece.translation().x() = 1.5;
  test::expectInputError([&] { motionOf(cell, plan); }, "of the workpiece: out of the robot's reach");
  cell.T_base_workpiece.translation().x() = 3.0;
  test::expectInputError([&] { motionOf(cell, plan); }, "raster row 0 at x -0.0050, y 0.0020, z 0.0800 m");
  cell = SensingCell();
  cell.robot.joints[0].upper = 0.05;
  test::expectInputError([&] { motionOf(cell, plan); }, "joint_1 is 0.05");
  cell.robot.joints[0].upper = -3.0;
  test::expectInputError([&] { motionOf(cell, plan); }, "joint_1 is");
}

TEST(RobotMotion, CanBeCancelled) {
  const SensingCell cell;
  const std::atomic<bool> is_cancelled{true};
  const RasterPlan plan = planOf(cell);
  EXPECT_THROW(RobotMotion(plan, cell.robot, cell.T_base_workpiece, cell.T_tip_sensor, Progress({}, &is_cancelled)),
               Interrupted);
}

}  // namespace
}  // namespace scan_to_path::sensing
