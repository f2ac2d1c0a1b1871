// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/plan_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan_motion_fixture.h"

namespace scan_to_path::motion {
namespace {

using scan_to_path::test::denavitHartenberg;
using test::countVerdicts;
using test::PlanMotionTest;
using test::Raster;
using test::rasterPath;

TEST_F(PlanMotionTest, TimesRiseAndNeitherFeedNorJointSpeedIsExceeded) {
  const MotionPlan result = plan(rasterPath());
  const auto& points = result.trajectory.points;
  EXPECT_EQ(points.front().time, 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double dt = points[i].time - points[i - 1].time;
    ASSERT_GE(dt, 1.9e-6);
    const auto tcp = [&](const JointVector& q) {
      return Vector3((denavitHartenberg(q.data()) * T_tip_tcp_).translation());
    };
    // Positions are rounded to 1e-15 m, times to 1e-14 s.
    EXPECT_LE((tcp(points[i].q) - tcp(points[i - 1].q)).norm(), 0.05 * dt * (1 + 1e-6) + 1e-12);
    for (int j = 0; j < 6; ++j) {
      EXPECT_LE(
          std::abs(points[i].q[j] - points[i - 1].q[j]),
          options_.speed_fraction * robot_.joints[static_cast<std::size_t>(j)].max_velocity * dt * (1 + 1e-6) + 1e-12);
    }
  }
  // Five rows of at least 0.24 m at 0.05 m/s.
  EXPECT_GT(points.back().time, 5 * 0.24 / 0.05);
}

TEST_F(PlanMotionTest, SpeedsAreNamedAndKept) {
  Raster raster;
  raster.feed = 3.0;
  options_.least_feed_share = 1.0;
  const MotionPlan result = plan(rasterPath(raster));
  EXPECT_GT(countVerdicts(result)[Verdict::speed], 100);
  const auto& points = result.trajectory.points;
  for (std::size_t i = 1; i < points.size(); ++i) {
    for (int j = 0; j < 6; ++j) {
      const double limit = options_.speed_fraction * robot_.joints[static_cast<std::size_t>(j)].max_velocity;
      ASSERT_LE(std::abs(points[i].q[j] - points[i - 1].q[j]) / (points[i].time - points[i - 1].time),
                limit * (1 + 1e-6));
    }
  }
}

/// joint_1 turns the tool about the base, 0.855 m from its axis (0.1 m to axis 2, 0.755 m of forearm, the hand straight
/// down), by 0.005 rad from waypoint to waypoint; the other joints stand still.
toolpath::ToolPath circlePath(const robot::Robot& robot, const Frame& T_tip_tcp, double feed) {
  toolpath::ToolPath path;
  path.process = "cutting";
  path.frame = "base_link";
  path.T_contact_tcp = test::halfTurn();
  path.segments.push_back({"row", {}});
  for (int i = 0; i <= 20; ++i) {
    JointVector q(6);
    q << 0.005 * i, 0.0, 0.0, 0.0, M_PI_2, 0.0;
    const Frame pose = robot::forwardKinematics(robot, q) * T_tip_tcp * path.T_contact_tcp.inverse();
    path.segments[0].waypoints.push_back({pose, feed, true, 0.0});
  }
  return path;
}

// joint_1 may turn at 0.9 * 0.05 = 0.045 rad/s, which drives 0.045 * 0.855 = 0.038475 m/s on the circle.
class LoweredFeedTest : public PlanMotionTest {
protected:
  LoweredFeedTest() {
    T_tip_tcp_ = geometry::makeFrame({0, 0, 0.2}, Vector3::Zero());
    robot_.joints[0].max_velocity = 0.05;
  }

  MotionPlan at(double feed) const { return plan(circlePath(robot_, T_tip_tcp_, feed)); }
};

TEST_F(LoweredFeedTest, TheFeedIsWhatTheJointCanDo) {
  MotionPlan result = at(0.05);
  EXPECT_EQ(countVerdicts(result)[Verdict::ok], 21);
  ASSERT_EQ(result.feeds.size(), 21U);
  EXPECT_EQ(result.feeds[0], 0.05);  // an axis move leads there
  for (std::size_t i = 1; i <= 20; ++i) {
    EXPECT_DOUBLE_EQ(result.feeds[i], 0.036754) << "0.95^5 of it is 0.038689, 0.95^6 0.0367546";
    EXPECT_EQ(result.verdicts[i].unit, "rad/s");
    EXPECT_NEAR(result.verdicts[i].margin, 0.045 - 0.036754 / 0.855, 1e-6);
  }
  // Between the ramps of 0.7 mm at both ends a chord of 4.275 mm takes what it takes at that feed.
  const auto& points = result.trajectory.points;
  ASSERT_EQ(points.size(), 21U);
  const double chord = 2.0 * 0.855 * std::sin(0.0025);
  for (std::size_t i = 2; i < 20; ++i) EXPECT_NEAR(points[i].time - points[i - 1].time, chord / 0.036754, 1e-6);
  result = at(0.038);
  EXPECT_EQ(result.feeds, std::vector<double>(21, 0.038)) << "slow enough";
}

TEST_F(LoweredFeedTest, BelowTheLeastShareTheWaypointFails) {
  MotionPlan result = at(0.2);  // 0.192 of it could be driven
  EXPECT_EQ(countVerdicts(result)[Verdict::speed], 20);
  EXPECT_EQ(result.feeds, std::vector<double>(21, 0.2));
  EXPECT_EQ(result.verdicts[7].reason, "joint_1 needs 0.2339 rad/s, limit 0.0450 rad/s");
  EXPECT_EQ(result.verdicts[7].remedy,
            "lower the feed to 0.0385 m/s (motion.least_feed_share allows 0.0500 m/s), or move or turn the part");
  options_.least_feed_share = 0.19;
  result = at(0.2);
  EXPECT_EQ(countVerdicts(result)[Verdict::ok], 21);
  EXPECT_DOUBLE_EQ(result.feeds[7], 0.038);
}

TEST_F(LoweredFeedTest, AShareOfOneFailsAtOnce) {
  options_.least_feed_share = 1.0;
  const MotionPlan result = at(0.05);
  EXPECT_EQ(countVerdicts(result)[Verdict::speed], 20);
  EXPECT_EQ(result.feeds, std::vector<double>(21, 0.05));
  EXPECT_EQ(result.verdicts[7].remedy, "lower the feed to 0.0385 m/s, or move or turn the part");
}

TEST_F(LoweredFeedTest, MovesInTheAirKeepTheFeedAskedFor) {
  auto path = circlePath(robot_, T_tip_tcp_, 0.2);
  for (auto& waypoint : path.segments[0].waypoints) waypoint.process_on = false;
  const MotionPlan result = plan(path);
  EXPECT_EQ(countVerdicts(result)[Verdict::ok], 21);
  EXPECT_EQ(result.feeds, std::vector<double>(21, 0.2));
}

TEST_F(PlanMotionTest, TheControllersAxisHasASpeedToo) {
  Raster raster;
  raster.feed = 3.0;
  robot_.coupled_axis = robot::CoupledAxis{2, {1, 2}, -10.0, 10.0};
  const MotionPlan result = plan(rasterPath(raster));
  const auto& points = result.trajectory.points;
  const double limit = options_.speed_fraction * robot_.joints[2].max_velocity;
  double fastest = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const JointVector step = points[i].q - points[i - 1].q;
    fastest = std::max(fastest, std::abs(step[1] + step[2]) / (points[i].time - points[i - 1].time));
  }
  EXPECT_LE(fastest, limit * (1 + 1e-6));
}

}  // namespace
}  // namespace scan_to_path::motion
