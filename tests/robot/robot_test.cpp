// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/robot.h"

#include <gmock/gmock.h>

#include <array>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>

#include "scan_to_path/common/error.h"
#include "scan_to_path/robot/kdl_chain.h"
#include "support/irb2400.h"

namespace scan_to_path::robot {
namespace {

using geometry::rotationAngle;
using test::denavitHartenberg;
using test::irb2400;
using test::randomJoints;

// Six products of rotations and translations of about 1 m in double precision: some tens of ulps.
constexpr double rounding = 1e-14;

TEST(ForwardKinematics, PutsTheFlangeWhereThePublishedDimensionsSay) {
  const Robot robot = irb2400();
  const Frame T = forwardKinematics(robot, JointVector::Zero(6));
  EXPECT_LT((T.translation() - Vector3(0.940, 0.0, 1.455)).norm(), rounding);
  EXPECT_LT((T.linear().col(2) - Vector3::UnitX()).norm(), rounding);
  EXPECT_LT((T.linear().col(0) + Vector3::UnitZ()).norm(), rounding);
}

TEST(ForwardKinematics, AgreesWithDenavitHartenberg) {
  const Robot robot = irb2400();
  Random random(1);
  for (int k = 0; k < 10000; ++k) {
    const JointVector q = randomJoints(robot, random);
    const Frame T = forwardKinematics(robot, q), oracle = denavitHartenberg(q.data());
    ASSERT_LT((T.translation() - oracle.translation()).norm(), rounding);
    ASSERT_LT(rotationAngle(T.linear(), oracle.linear()), rounding);
  }
}

TEST(ForwardKinematics, DenavitHartenbergCheckSeesAWrongSign) {
  Robot robot = irb2400();
  robot.joints[2].axis = -robot.joints[2].axis;
  Random random(1);
  const JointVector q = randomJoints(robot, random);
  EXPECT_GT((forwardKinematics(robot, q).translation() - denavitHartenberg(q.data()).translation()).norm(), 1e-3);
}

/// A seven-axis chain with oblique axes and twisted frames.
Robot obliqueRobot(Random& random) {
  Robot robot;
  for (int i = 0; i < 7; ++i) {
    const auto any = [&random] { return Vector3(random.gaussian(), random.gaussian(), random.gaussian()); };
    Joint joint;
    joint.name = "j" + std::to_string(i);
    joint.T_parent_joint = geometry::makeFrame(0.3 * any(), any());
    joint.axis = any().normalized();
    joint.lower = -3.0;
    joint.upper = 3.0;
    joint.max_velocity = 1.0;
    robot.joints.push_back(joint);
    robot.T_last_tip = geometry::makeFrame(0.1 * any(), any());
  }
  return robot;
}

/// Two KDL segments per joint, a fixed and a movable one: not the way kdlChain builds it.
KDL::Frame kdlForwardKinematics(const Robot& robot, const JointVector& q) {
  KDL::Chain chain;
  for (const Joint& joint : robot.joints) {
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), toKdl(joint.T_parent_joint)));
    const KDL::Vector axis(joint.axis.x(), joint.axis.y(), joint.axis.z());
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Vector::Zero(), axis, KDL::Joint::RotAxis)));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), toKdl(robot.T_last_tip)));
  KDL::JntArray angles(static_cast<unsigned>(robot.dof()));
  angles.data = q;
  KDL::Frame T;
  KDL::ChainFkSolverPos_recursive(chain).JntToCart(angles, T);
  return T;
}

TEST(ForwardKinematics, AgreesWithKdlOnObliqueChains) {
  Random random(2);
  for (int k = 0; k < 1000; ++k) {
    const Robot robot = obliqueRobot(random);
    const JointVector q = randomJoints(robot, random);
    const Frame T = forwardKinematics(robot, q);
    ASSERT_TRUE(KDL::Equal(toKdl(T), kdlForwardKinematics(robot, q), 10 * rounding)) << "case " << k;
  }
}

TEST(JacobianMatrix, AgreesWithCentralDifferences) {
  Random random(3);
  constexpr double step = 1e-5;
  // Central differences err by step^2 / 6 times the third derivative (< 10 m here) and by rounding / step.
  constexpr double tolerance = 10 * step * step / 6 + 20 * rounding / step;
  for (int k = 0; k < 200; ++k) {
    const Robot robot = k % 2 == 0 ? irb2400() : obliqueRobot(random);
    const JointVector q = randomJoints(robot, random);
    const auto J = jacobian(robot, q);
    ASSERT_EQ(J.cols(), robot.dof());
    for (int i = 0; i < robot.dof(); ++i) {
      JointVector forward = q, backward = q;
      forward[i] += step;
      backward[i] -= step;
      const Frame T_f = forwardKinematics(robot, forward), T_b = forwardKinematics(robot, backward);
      const Vector3 linear = (T_f.translation() - T_b.translation()) / (2 * step);
      const Eigen::AngleAxisd turned(Eigen::Matrix3d(T_f.linear() * T_b.linear().transpose()));
      ASSERT_LT((J.col(i).head<3>() - linear).norm(), tolerance);
      ASSERT_LT((J.col(i).tail<3>() - turned.axis() * turned.angle() / (2 * step)).norm(), tolerance);
    }
  }
}

TEST(NearestLimit, IsThatOfTheNearestJoint) {
  const Robot robot = irb2400();
  JointVector q = JointVector::Zero(6);
  EXPECT_DOUBLE_EQ(nearestLimit(robot, q).margin, 60.0 * M_PI / 180.0);
  EXPECT_EQ(nearestLimit(robot, q).joint, 2);
  q[4] = 119.0 * M_PI / 180.0;
  EXPECT_NEAR(nearestLimit(robot, q).margin, M_PI / 180.0, 1e-15);
  EXPECT_EQ(limitName(robot, nearestLimit(robot, q)), "joint_5");
  q[5] = -7.0;
  EXPECT_NEAR(nearestLimit(robot, q).margin, 400.0 * M_PI / 180.0 - 7.0, 1e-14);
  EXPECT_EQ(nearestLimit(robot, q).joint, 5);
  EXPECT_EQ(limitMargin(robot, q), nearestLimit(robot, q).margin);
}

TEST(NearestLimit, OfContinuousJointsAloneIsInfinite) {
  Robot robot;
  robot.joints.resize(2);
  for (Joint& joint : robot.joints) {
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
  }
  EXPECT_EQ(limitMargin(robot, JointVector::Zero(2)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearestLimit(robot, JointVector::Zero(2)).joint, 0);
}

// 50 and 40 degrees are within -100 to 110 and -60 to 65; their sum is 25 degrees beyond the controller's 65.
TEST(NearestLimit, SeesTheCoupledAxis) {
  const Robot robot = test::irb2400WithLinkage();
  JointVector q = JointVector::Zero(6);
  q[1] = 50.0 * M_PI / 180.0;
  q[2] = 40.0 * M_PI / 180.0;
  EXPECT_GT(limitMargin(irb2400(), q), 0.0);
  const NearestLimit nearest = nearestLimit(robot, q);
  EXPECT_TRUE(nearest.is_coupled);
  EXPECT_NEAR(nearest.margin, -25.0 * M_PI / 180.0, 1e-15);
  EXPECT_NEAR(nearest.angle, M_PI_2, 1e-15);
  EXPECT_NEAR(coupledMargin(robot, q), nearest.margin, 1e-15);
  EXPECT_EQ(limitName(robot, nearest), "controller axis joint_2 + joint_3");
  q[1] = -q[1];
  EXPECT_NEAR(coupledMargin(robot, q), 50.0 * M_PI / 180.0, 1e-15);  // at -10 degrees of -60
  EXPECT_FALSE(nearestLimit(robot, q).is_coupled);
}

TEST(ControllerAxes, SumStandsInItsJointsPlace) {
  JointVector q(6);
  q << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  JointVector expected = q;
  EXPECT_EQ(controllerAxes(irb2400(), q), expected);
  expected[2] = 0.5;
  EXPECT_LT((controllerAxes(test::irb2400WithLinkage(), q) - expected).norm(), 1e-15);
}

TEST(LargestTurns, AreTheJointsOrTheControllersAxes) {
  const Robot robot = test::irb2400WithLinkage();
  const JointVector from = JointVector::Zero(6);
  JointVector to(6);
  to << -0.1, 0.2, 0.3, 0.0, 0.0, 0.0;
  EXPECT_NEAR(largestTurns(robot, from, to)[2], 0.5, 1e-15);
  EXPECT_NEAR(largestTurns(robot, from, to)[0], 0.1, 1e-15);
  to[2] = -0.3;
  EXPECT_NEAR(largestTurns(robot, from, to)[2], 0.3, 1e-15);
  EXPECT_NEAR(largestTurns(irb2400(), from, to)[2], 0.3, 1e-15);
}

TEST(Irb2400, HasThePublishedLimitsAndSpeeds) {
  const Robot robot = irb2400();
  ASSERT_EQ(robot.dof(), 6);
  constexpr std::array<std::array<double, 3>, 6> published = {
      {{-180, 180, 150}, {-100, 110, 150}, {-60, 65, 150}, {-200, 200, 360}, {-120, 120, 360}, {-400, 400, 450}}};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(robot.joints[i].name, "joint_" + std::to_string(i + 1));
    EXPECT_NEAR(robot.joints[i].lower * 180.0 / M_PI, published[i][0], 1e-12);
    EXPECT_NEAR(robot.joints[i].upper * 180.0 / M_PI, published[i][1], 1e-12);
    EXPECT_NEAR(robot.joints[i].max_velocity * 180.0 / M_PI, published[i][2], 1e-12);
  }
  EXPECT_THAT(robot.link_names, testing::UnorderedElementsAre("base_link", "link_1", "link_2", "link_3", "link_4",
                                                              "link_5", "link_6", "tool0"));
}

TEST(ReadRobot, NamesTheFile) {
  EXPECT_THROW(readRobot("/nowhere/robot.urdf", "base_link", "tool0"), InputError);
  try {
    readRobot(test::irb2400File(), "base_link", "tool1");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("irb2400.urdf: "), testing::HasSubstr("tool0")));
  }
}

}  // namespace
}  // namespace scan_to_path::robot
