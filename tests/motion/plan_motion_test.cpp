// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/plan_motion.h"

#include <gmock/gmock.h>

#include "plan_motion_fixture.h"
#include "scan_to_path/motion/trajectory.h"

namespace scan_to_path::motion {
namespace {

using geometry::rotationAngle;
using scan_to_path::test::denavitHartenberg;
using test::countVerdicts;
using test::moved;
using test::PlanMotionTest;
using test::Raster;
using test::rasterPath;
using test::waypointPoints;
using test::waypoints;

/// Position [m] and angle [rad] by which the tool misses its waypoints, by Denavit-Hartenberg.
std::pair<double, double> worstMiss(const toolpath::ToolPath& path, const MotionPlan& plan, const Frame& T_tip_tcp) {
  double position = 0.0, angle = 0.0;
  for (const auto& [name, point] : waypointPoints(plan.trajectory)) {
    const auto& pose =
        path.segments[static_cast<std::size_t>(name.first)].waypoints[static_cast<std::size_t>(name.second)].pose;
    const Frame expected = pose * path.T_contact_tcp, got = denavitHartenberg(point.q.data()) * T_tip_tcp;
    position = std::max(position, (expected.translation() - got.translation()).norm());
    angle = std::max(angle, rotationAngle(expected.linear(), got.linear()));
  }
  return {position, angle};
}

TEST(TipPose, PutsTheToolOnTheContactPointByHand) {
  // A vertical contact at (1, 0, 0), the tool 0.2 m long along the flange's z: the flange is 0.2 m above, z downwards.
  const Frame contact = geometry::makeFrame({1, 0, 0}, Vector3::Zero());
  const Frame T = tipPose(contact, test::halfTurn(), geometry::makeFrame({0, 0, 0.2}, Vector3::Zero()));
  EXPECT_LT((T.translation() - Vector3(1, 0, 0.2)).norm(), 1e-15);
  EXPECT_LT((T.linear().col(2) + Vector3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((T.linear().col(0) - Vector3::UnitX()).norm(), 1e-15);
}

TEST(TipPose, LeadTipsTheToolByHand) {
  // Lead of 90 degrees about y: the tool's +z, out of the tool into the work, points along -x.
  const Frame lead = geometry::makeFrame(Vector3::Zero(), {0, M_PI_2, 0});
  const Frame T =
      tipPose(Frame::Identity(), lead * test::halfTurn(), geometry::makeFrame({0, 0, 0.2}, Vector3::Zero()));
  EXPECT_LT((T.linear().col(2) + Vector3::UnitX()).norm(), 1e-15);
  EXPECT_LT((T.translation() - Vector3(0.2, 0, 0)).norm(), 1e-15);
}

TEST(TipPose, OfATiltedSpindleByHand) {
  // The tool leaves the flange along its x axis (turn about y by 90 degrees) at 0.1 m: flange x points into the work.
  const Frame mount = geometry::makeFrame({0.1, 0, 0}, {0, M_PI_2, 0});
  const Frame T = tipPose(Frame::Identity(), test::halfTurn(), mount);
  EXPECT_LT((T.linear().col(0) + Vector3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((T.translation() - Vector3(0, 0, 0.1)).norm(), 1e-15);
}

TEST_F(PlanMotionTest, DrivesARasterThroughEveryWaypoint) {
  const auto path = rasterPath();
  const MotionPlan result = plan(path);
  EXPECT_EQ(countVerdicts(result)[Verdict::ok], static_cast<int>(waypoints(path)));
  EXPECT_EQ(waypointPoints(result.trajectory).size(), waypoints(path));
  const auto [position, angle] = worstMiss(path, result, T_tip_tcp_);
  EXPECT_LE(position, 1e-6);
  EXPECT_LE(angle, 0.001 * M_PI / 180.0);
  for (const TrajectoryPoint& point : result.trajectory.points) EXPECT_GE(robot::limitMargin(robot_, point.q), 0.0);
}

TEST_F(PlanMotionTest, WaypointCheckSeesAWrongToolAndADroppedTurn) {
  const auto path = rasterPath();
  const MotionPlan result = plan(path);
  Frame wrong = T_tip_tcp_;
  wrong.translation().z() += 2e-6;
  EXPECT_GT(worstMiss(path, result, wrong).first, 1e-6);
  auto other = path;
  other.T_contact_tcp = Frame::Identity();
  EXPECT_GT(worstMiss(other, result, T_tip_tcp_).second, 1.0);
}

TEST_F(PlanMotionTest, MovingRobotAndPartTogetherChangesNothing) {
  const auto path = rasterPath();
  const Frame T_world_base = geometry::makeFrame({0.3, -0.4, 0.5}, {0.1, -0.2, 0.7});
  robot::Robot elsewhere = robot_;
  elsewhere.joints[0].T_parent_joint = T_world_base * elsewhere.joints[0].T_parent_joint;
  const MotionPlan here = plan(path), there = planMotion(moved(path, T_world_base), elsewhere, T_tip_tcp_, options_);
  ASSERT_EQ(here.trajectory.points.size(), there.trajectory.points.size());
  for (std::size_t i = 0; i < here.trajectory.points.size(); ++i) {
    // Both are solved to 1e-10 m; the Jacobian's inverse is below 100.
    ASSERT_LT((here.trajectory.points[i].q - there.trajectory.points[i].q).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST_F(PlanMotionTest, TurningThePathAboutTheRobotTurnsJointOne) {
  const auto path = rasterPath();
  const double angle = 0.4;
  const Frame turn = geometry::makeFrame(Vector3::Zero(), {0, 0, angle});
  const MotionPlan here = plan(path), there = plan(moved(path, turn));
  ASSERT_EQ(here.trajectory.points.size(), there.trajectory.points.size());
  for (std::size_t i = 0; i < here.trajectory.points.size(); ++i) {
    JointVector expected = here.trajectory.points[i].q;
    expected[0] += angle;
    ASSERT_LT((expected - there.trajectory.points[i].q).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST_F(PlanMotionTest, SameInputSameBytes) {
  const auto path = rasterPath();
  EXPECT_EQ(formatTrajectory(plan(path).trajectory), formatTrajectory(plan(path).trajectory));
}

TEST_F(PlanMotionTest, ZigZagDoesNotWindUpTheWrist) {
  Raster raster;
  raster.rows = 41;
  raster.points = 5;
  const MotionPlan result = plan(rasterPath(raster));
  EXPECT_EQ(countVerdicts(result)[Verdict::ok], static_cast<int>(result.verdicts.size()));
  double lowest = 1e9, highest = -1e9;
  for (const auto& point : result.trajectory.points) {
    lowest = std::min(lowest, point.q[5]);
    highest = std::max(highest, point.q[5]);
  }
  EXPECT_LT(highest - lowest, 2.0 * M_PI + 0.5);  // rows have two directions, half a turn apart
}

TEST_F(PlanMotionTest, TakesTheConfigurationThatFailsLeast) {
  // Both ways of bending the elbow reach the first waypoint; with joint_3 kept from one of them, the other is taken.
  const auto path = rasterPath();
  const MotionPlan first = plan(path);
  const double elbow = first.trajectory.points.front().q[2];
  robot_.joints[4].lower = -1e-3;
  const MotionPlan up = plan(path);
  robot_.joints[4].lower = -2.0;
  robot_.joints[4].upper = 1e-3;
  const MotionPlan down = plan(path);
  EXPECT_GT(up.trajectory.points.front().q[4], 0.0);
  EXPECT_LT(down.trajectory.points.front().q[4], 0.0);
  EXPECT_EQ(countVerdicts(up)[Verdict::ok], static_cast<int>(up.verdicts.size()));
  EXPECT_EQ(countVerdicts(down)[Verdict::ok], static_cast<int>(down.verdicts.size()));
  EXPECT_NEAR(up.trajectory.points.front().q[2], elbow, 1e-6);
}

// Of two ways to reach the start the one is taken that the controller drives.
TEST_F(PlanMotionTest, TakesTheConfigurationThatTheControllerAllows) {
  T_tip_tcp_ = geometry::makeFrame({0, 0, 0.2}, Vector3::Zero());
  for (robot::Joint& joint : robot_.joints) {
    joint.lower = -4.2;
    joint.upper = 4.2;
  }
  const auto path = rasterPath();
  const MotionPlan first = plan(path);
  const JointVector q = first.trajectory.points.front().q;
  robot_.coupled_axis = robot::CoupledAxis{2, {1, 2}, q[1] + q[2] - 3.0 * M_PI, q[1] + q[2] - 0.7};
  const MotionPlan other = plan(path);
  EXPECT_EQ(countVerdicts(other)[Verdict::joint_limit], 0);
  for (const auto& point : other.trajectory.points) EXPECT_GE(robot::coupledMargin(robot_, point.q), 0.0);
}

TEST_F(PlanMotionTest, BadInputIsNamed) {
  const auto complaint = [this](auto&& change) -> std::string {
    auto path = rasterPath();
    MotionOptions options;
    change(path, options);
    try {
      planMotion(path, robot_, T_tip_tcp_, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  using testing::AllOf;
  using testing::HasSubstr;
  using toolpath::ToolPath;
  EXPECT_THAT(complaint([](ToolPath& p, MotionOptions&) { p.frame = "workpiece"; }),
              AllOf(HasSubstr("workpiece"), HasSubstr("base_link")));
  EXPECT_THAT(complaint([](ToolPath& p, MotionOptions&) { p.segments.clear(); }), HasSubstr("waypoints"));
  EXPECT_THAT(complaint([](ToolPath& p, MotionOptions&) { p.segments[1].waypoints[7].feed = 0.0; }),
              AllOf(HasSubstr("row_1 waypoint 7"), HasSubstr("feed")));
  EXPECT_THAT(complaint([](ToolPath& p, MotionOptions&) { p.segments[1].waypoints[7].pose.translation().x() = NAN; }),
              AllOf(HasSubstr("row_1 waypoint 7"), HasSubstr("finite")));
  EXPECT_THAT(complaint([](ToolPath&, MotionOptions& o) { o.chord_tolerance = 0.0; }),
              HasSubstr("motion.chord_tolerance"));
  EXPECT_EQ(complaint([](ToolPath& p, MotionOptions&) { p.segments[0].waypoints[0].feed = 0.0; }), "accepted");
}

TEST_F(PlanMotionTest, StopsWhenAsked) {
  const std::atomic<bool> cancelled{true};
  EXPECT_THROW(planMotion(rasterPath(), robot_, T_tip_tcp_, options_, Progress({}, &cancelled)), Interrupted);
}

}  // namespace
}  // namespace scan_to_path::motion
