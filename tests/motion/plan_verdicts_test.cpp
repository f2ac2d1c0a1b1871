// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/plan_motion.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "plan_motion_fixture.h"
#include "scan_to_path/motion/trajectory.h"

namespace scan_to_path::motion {
namespace {

using test::countVerdicts;
using test::moved;
using test::PlanMotionTest;
using test::rasterPath;
using test::waypointPoints;
using test::waypoints;

TEST_F(PlanMotionTest, UnreachableWaypointsAreNamedAndLeftOut) {
  auto path = rasterPath();
  for (int i = 20; i < 30; ++i) path.segments[2].waypoints[static_cast<std::size_t>(i)].pose.translation().x() += 2.0;
  const MotionPlan result = plan(path);
  EXPECT_EQ(countVerdicts(result)[Verdict::unreachable], 10);
  const auto points = waypointPoints(result.trajectory);
  EXPECT_EQ(points.size(), waypoints(path) - 10);
  for (const WaypointVerdict& verdict : result.verdicts) {
    EXPECT_EQ(verdict.verdict == Verdict::unreachable,
              verdict.segment == 2 && verdict.index >= 20 && verdict.index < 30);
    if (verdict.verdict != Verdict::unreachable) continue;
    EXPECT_LT(verdict.margin, -0.5);
    EXPECT_EQ(verdict.unit, "m");
    EXPECT_FALSE(verdict.reason.empty() || verdict.remedy.empty());
    EXPECT_EQ(points.count({verdict.segment, verdict.index}), 0u);
  }
}

TEST_F(PlanMotionTest, AFirstWaypointOutOfReachDoesNotSpoilTheRest) {
  auto path = rasterPath();
  path.segments[0].waypoints[0].pose.translation().z() += 5.0;
  const MotionPlan result = plan(path);
  EXPECT_EQ(result.verdicts.front().verdict, Verdict::unreachable);
  EXPECT_EQ(countVerdicts(result)[Verdict::ok], static_cast<int>(waypoints(path)) - 1);
}

TEST_F(PlanMotionTest, NothingInReachIsAllUnreachable) {
  const MotionPlan result = plan(moved(rasterPath(), geometry::makeFrame({3, 0, 0}, Vector3::Zero())));
  EXPECT_EQ(countVerdicts(result)[Verdict::unreachable], static_cast<int>(result.verdicts.size()));
  EXPECT_TRUE(result.trajectory.points.empty());
  EXPECT_EQ(result.max_chord_error, 0.0);
}

TEST_F(PlanMotionTest, JointLimitsAreNamed) {
  robot_.joints[0].upper = 0.02;  // the raster reaches from about -0.1 to 0.1 rad
  robot_.joints[0].lower = -1.0;
  const MotionPlan result = plan(rasterPath());
  auto counts = countVerdicts(result);
  EXPECT_GT(counts[Verdict::joint_limit], 50);
  EXPECT_GT(counts[Verdict::ok], 50);
  for (const WaypointVerdict& verdict : result.verdicts) {
    if (verdict.verdict != Verdict::joint_limit) continue;
    EXPECT_LT(verdict.margin, 0.0);
    EXPECT_THAT(verdict.reason, testing::AllOf(testing::HasSubstr("joint_1"), testing::HasSubstr("limit 0.0200 rad")));
  }
}

/// A straight path that leads the wrist through its singularity: joint_5 goes from bent one way to the other.
toolpath::ToolPath singularPath(const robot::Robot& robot, const Frame& T_tip_tcp, double past) {
  toolpath::ToolPath path;
  path.process = "cutting";
  path.frame = "base_link";
  path.T_contact_tcp = test::halfTurn();
  path.segments.resize(1);
  path.segments[0].name = "row";
  for (int i = -20; i <= 20; ++i) {
    JointVector q(6);
    q << 0.0, 0.3, 0.2, 0.0, 0.02 * i, 0.0;
    Frame pose = robot::forwardKinematics(robot, q) * T_tip_tcp * path.T_contact_tcp.inverse();
    pose.translation().y() += past;  // passing beside the singular pose makes joint_4 and joint_6 turn at once
    pose.translation().x() += 0.001 * i;
    path.segments[0].waypoints.push_back({pose, 0.05, true, 0.0});
  }
  return path;
}

TEST_F(PlanMotionTest, SingularPosesAreNamed) {
  const MotionPlan result = plan(singularPath(robot_, T_tip_tcp_, 0.0));
  EXPECT_GE(countVerdicts(result)[Verdict::singular], 1);
  for (const WaypointVerdict& verdict : result.verdicts) {
    EXPECT_TRUE(verdict.verdict != Verdict::singular || std::abs(verdict.index - 20) <= 5) << verdict.index;
  }
}

TEST_F(PlanMotionTest, JumpsAreNamed) {
  // From one side of the robot to the other, the wrist through the shoulder: out of reach on the way, so the arm
  // cannot get there without leaving the line. Joint limits would be broken too, and named instead.
  for (robot::Joint& joint : robot_.joints) {
    joint.lower = -4.2;
    joint.upper = 4.2;
  }
  T_tip_tcp_ = geometry::makeFrame({0, 0, 0.2}, Vector3::Zero());
  auto path = rasterPath();
  path.segments.resize(1);
  path.segments[0].waypoints.resize(10);
  for (int i = 0; i < 10; ++i) {
    const Vector3 point(i < 5 ? 0.9 : -0.7, 0.001 * i, 0.330);
    path.segments[0].waypoints[static_cast<std::size_t>(i)].pose = geometry::makeFrame(point, Vector3::Zero());
  }
  const MotionPlan result = plan(path);
  for (const WaypointVerdict& verdict : result.verdicts) {
    EXPECT_EQ(verdict.verdict, verdict.index == 5 ? Verdict::jump : Verdict::ok)
        << verdict.index << " " << verdict.reason;
  }
  EXPECT_EQ(result.verdicts[5].unit, "rad");
  EXPECT_LT(result.verdicts[5].margin, -0.5);
}

// Each joint keeps within its limits; the range of the controller's axis is set to the lower half of what the raster
// needs.
TEST_F(PlanMotionTest, TheControllersAxisIsALimitToo) {
  const auto path = moved(rasterPath(), geometry::makeFrame({0.35, 0.0, -0.35}, Vector3::Zero()));
  const MotionPlan serial = plan(path);
  ASSERT_EQ(countVerdicts(serial)[Verdict::ok], static_cast<int>(waypoints(path)));
  robot_.coupled_axis = robot::CoupledAxis{2, {1, 2}, -1.0, 0.0};
  std::vector<double> sums;
  for (const auto& entry : waypointPoints(serial.trajectory)) sums.push_back(entry.second.q[1] + entry.second.q[2]);
  std::vector<double> sorted = sums;
  std::sort(sorted.begin(), sorted.end());
  robot_.coupled_axis->lower = sorted.front() - 1.0;
  robot_.coupled_axis->upper = 0.5 * (sorted[sorted.size() / 2] + sorted[sorted.size() / 2 + 1]);
  const MotionPlan coupled = plan(path);
  ASSERT_EQ(coupled.verdicts.size(), sums.size());
  EXPECT_GT(countVerdicts(coupled)[Verdict::joint_limit], static_cast<int>(sums.size() / 3));
  EXPECT_GT(countVerdicts(coupled)[Verdict::ok], static_cast<int>(sums.size() / 4));
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const WaypointVerdict& verdict = coupled.verdicts[i];
    if (verdict.verdict == Verdict::joint_limit) {
      EXPECT_THAT(verdict.reason, testing::HasSubstr("controller axis joint_2 + joint_3 is at"));
      // The waypoint itself, or a point of the move that leads to it, which goes on from an inner one.
      EXPECT_LE(verdict.margin, robot_.coupled_axis->upper - sums[i] + 1e-9);
    } else {
      EXPECT_LE(sums[i], robot_.coupled_axis->upper);
    }
  }
}

// With the range wide open nothing changes; a robot that is turned about its first axis keeps all verdicts.
TEST_F(PlanMotionTest, AWideCoupledAxisChangesNothing) {
  const auto path = rasterPath();
  const std::string bare = formatTrajectory(plan(path).trajectory);
  robot_.coupled_axis = robot::CoupledAxis{2, {1, 2}, -10.0, 10.0};
  // Slow enough for the controller's axis not to be what limits a move.
  EXPECT_EQ(formatTrajectory(plan(path).trajectory), bare);
  const MotionPlan here = plan(path), there = plan(moved(path, geometry::makeFrame(Vector3::Zero(), {0, 0, 0.4})));
  for (std::size_t i = 0; i < here.verdicts.size(); ++i) EXPECT_EQ(here.verdicts[i].verdict, there.verdicts[i].verdict);
}

}  // namespace
}  // namespace scan_to_path::motion
