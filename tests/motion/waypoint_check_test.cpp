// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/waypoint_check.h"

#include <gmock/gmock.h>

#include "support/irb2400.h"

namespace scan_to_path::motion {
namespace {

using scan_to_path::test::irb2400;
namespace test = scan_to_path::test;
using testing::HasSubstr;

class WaypointCheckTest : public testing::Test {
protected:
  WaypointCheckTest() {
    q_ << 0.1, 0.2, 0.1, 0.3, 0.8, 0.2;
    arrival_ = {{}, JointVector::Constant(6, 0.01), JointVector::Constant(6, 1.0), 0.05, true};
  }

  robot::Robot robot_ = irb2400();
  MotionOptions options_;
  JointVector q_{6};
  Arrival arrival_;
};

TEST_F(WaypointCheckTest, OkHasTheRelativelySmallestMargin) {
  const WaypointVerdict first = checkWaypoint(robot_, q_, nullptr, options_);
  EXPECT_EQ(first.verdict, Verdict::ok);
  EXPECT_EQ(first.unit, "rad");
  EXPECT_NEAR(first.margin, robot::limitMargin(robot_, q_), 1e-15);
  EXPECT_TRUE(first.reason.empty() && first.remedy.empty());
  arrival_.rate[4] = 0.99 * 0.9 * robot_.joints[4].max_velocity / 0.05;
  const WaypointVerdict second = checkWaypoint(robot_, q_, &arrival_, options_);
  EXPECT_EQ(second.verdict, Verdict::ok);
  EXPECT_EQ(second.unit, "rad/s");
  EXPECT_NEAR(second.margin, 0.01 * 0.9 * robot_.joints[4].max_velocity, 1e-12);
}

TEST_F(WaypointCheckTest, JointLimit) {
  q_[2] = 1.2;
  const WaypointVerdict verdict = checkWaypoint(robot_, q_, &arrival_, options_);
  EXPECT_EQ(verdict.verdict, Verdict::joint_limit);
  EXPECT_NEAR(verdict.margin, 65.0 * M_PI / 180.0 - 1.2, 1e-12);
  EXPECT_EQ(verdict.reason, "joint_3 is at 1.2000 rad, limit 1.1345 rad");
  EXPECT_FALSE(verdict.remedy.empty());
  q_[2] = -1.0;
  EXPECT_EQ(checkWaypoint(robot_, q_, nullptr, options_).verdict, Verdict::ok);
  options_.joint_limit_margin = 0.1;
  const WaypointVerdict lower = checkWaypoint(robot_, q_, nullptr, options_);
  EXPECT_EQ(lower.verdict, Verdict::joint_limit);
  EXPECT_EQ(lower.reason, "joint_3 is at -1.0000 rad, limit -0.9472 rad");
}

TEST_F(WaypointCheckTest, JointLimitOnTheWay) {
  arrival_.nearest_limit = q_;
  arrival_.nearest_limit[2] = 1.2;
  EXPECT_EQ(checkWaypoint(robot_, q_, &arrival_, options_).reason, "joint_3 is at 1.2000 rad, limit 1.1345 rad");
}

TEST_F(WaypointCheckTest, CoupledAxisLimit) {
  q_[1] = 0.8;
  q_[2] = 0.7;  // each within its own limits, the sum 0.3655 rad beyond 65 degrees
  EXPECT_EQ(checkWaypoint(robot_, q_, &arrival_, options_).verdict, Verdict::ok);
  robot_ = test::irb2400WithLinkage();
  const WaypointVerdict verdict = checkWaypoint(robot_, q_, &arrival_, options_);
  EXPECT_EQ(verdict.verdict, Verdict::joint_limit);
  EXPECT_NEAR(verdict.margin, 65.0 * M_PI / 180.0 - 1.5, 1e-12);
  EXPECT_EQ(verdict.reason, "controller axis joint_2 + joint_3 is at 1.5000 rad, limit 1.1345 rad");
  arrival_.nearest_limit = q_;
  q_[2] = 0.1;
  EXPECT_EQ(checkWaypoint(robot_, q_, &arrival_, options_).reason, verdict.reason) << "on the way";
}

TEST_F(WaypointCheckTest, Singular) {
  q_[4] = 0.01;
  const WaypointVerdict verdict = checkWaypoint(robot_, q_, &arrival_, options_);
  EXPECT_EQ(verdict.verdict, Verdict::singular);
  EXPECT_LT(verdict.margin, 0.0);
  EXPECT_THAT(verdict.reason, HasSubstr("limit 0.0200"));
}

TEST_F(WaypointCheckTest, SpeedOnlyWhereTheProcessIsOn) {
  arrival_.rate[3] = 7.9 / 0.05;
  const WaypointVerdict verdict = checkWaypoint(robot_, q_, &arrival_, options_);
  EXPECT_EQ(verdict.verdict, Verdict::speed);
  EXPECT_EQ(verdict.unit, "rad/s");
  EXPECT_NEAR(verdict.margin, 0.9 * 2.0 * M_PI - 7.9, 1e-12);
  EXPECT_EQ(verdict.reason, "joint_4 needs 7.9000 rad/s, limit 5.6549 rad/s");
  EXPECT_THAT(verdict.remedy, HasSubstr("lower the feed to 0.0358 m/s"));
  arrival_.process_on = false;
  EXPECT_EQ(checkWaypoint(robot_, q_, &arrival_, options_).verdict, Verdict::ok);
}

TEST_F(WaypointCheckTest, Jump) {
  arrival_.step[5] = 3.0;
  const WaypointVerdict verdict = checkWaypoint(robot_, q_, &arrival_, options_);
  EXPECT_EQ(verdict.verdict, Verdict::jump);
  EXPECT_NEAR(verdict.margin, 0.5 - 3.0, 1e-12);
  EXPECT_THAT(verdict.reason, HasSubstr("joint_6 turns by 3.0000 rad"));
}

TEST_F(WaypointCheckTest, TheWorstOfSeveralIsNamed) {
  arrival_.step[5] = 3.0;
  arrival_.rate[3] = 1e3;
  EXPECT_EQ(checkWaypoint(robot_, q_, &arrival_, options_).verdict, Verdict::jump);
  q_[4] = 0.0;
  EXPECT_EQ(checkWaypoint(robot_, q_, &arrival_, options_).verdict, Verdict::singular);
  q_[0] = 4.0;
  EXPECT_EQ(checkWaypoint(robot_, q_, &arrival_, options_).verdict, Verdict::joint_limit);
}

TEST_F(WaypointCheckTest, ContinuousJointsHaveNoLimitToName) {
  for (robot::Joint& joint : robot_.joints) {
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
  }
  const WaypointVerdict verdict = checkWaypoint(robot_, q_, nullptr, options_);
  EXPECT_EQ(verdict.verdict, Verdict::ok);
  EXPECT_TRUE(std::isfinite(verdict.margin));
}

TEST_F(WaypointCheckTest, UnreachableSaysByHowMuch) {
  Frame T = Frame::Identity();
  T.translation() = Vector3(3.0, 0.0, 0.5);
  const WaypointVerdict far = unreachableVerdict(T, {0.7, 0.1});
  EXPECT_EQ(far.verdict, Verdict::unreachable);
  EXPECT_EQ(far.margin, -0.7);
  EXPECT_EQ(far.unit, "m");
  EXPECT_THAT(far.reason, testing::AllOf(HasSubstr("(3.000, 0.000, 0.500) m"), HasSubstr("0.7000 m")));
  const WaypointVerdict turned = unreachableVerdict(T, {1e-9, 0.1});
  EXPECT_EQ(turned.margin, -0.1);
  EXPECT_EQ(turned.unit, "rad");
}

TEST(SmallestSingularValue, IsZeroExactlyInTheWristSingularity) {
  const robot::Robot robot = irb2400();
  const double length = characteristicLength(robot);
  EXPECT_NEAR(length, std::hypot(0.1, 0.615) + 0.705 + 0.135 + 0.755 + 0.085, 1e-12);
  JointVector q(6);
  q << 0.1, 0.2, 0.1, 0.3, 0.0, 0.2;
  // Square root of an eigenvalue that is rounded at 1e-16 times the largest.
  EXPECT_LT(smallestSingularValue(robot, q, length), 1e-7);
  double before = 0.0;
  for (const double bend : {0.01, 0.05, 0.2}) {
    q[4] = bend;
    const double value = smallestSingularValue(robot, q, length);
    EXPECT_GT(value, before);
    EXPECT_LT(value, bend);
    before = value;
  }
}

}  // namespace
}  // namespace scan_to_path::motion
