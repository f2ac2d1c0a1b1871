// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/plan_motion.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "motion/raster.h"
#include "scan_to_path/motion/trajectory.h"
#include "support/irb2400.h"

namespace scan_to_path::motion {
namespace {

using geometry::rotationAngle;
using scan_to_path::test::denavitHartenberg;
using scan_to_path::test::irb2400;
using test::moved;
using test::Raster;
using test::rasterPath;
using test::spindleMount;

std::map<Verdict, int> countVerdicts(const MotionPlan& plan) {
  std::map<Verdict, int> counts;
  for (const WaypointVerdict& verdict : plan.verdicts) ++counts[verdict.verdict];
  return counts;
}

/// The trajectory's point at every waypoint: the last one of those that name it.
std::map<std::pair<int, int>, TrajectoryPoint> waypointPoints(const Trajectory& trajectory) {
  std::map<std::pair<int, int>, TrajectoryPoint> points;
  for (const TrajectoryPoint& point : trajectory.points) points[{point.segment, point.index}] = point;
  return points;
}

std::size_t waypoints(const toolpath::ToolPath& path) {
  std::size_t count = 0;
  for (const auto& segment : path.segments) count += segment.waypoints.size();
  return count;
}

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

class PlanMotionTest : public testing::Test {
protected:
  MotionPlan plan(const toolpath::ToolPath& path) const { return planMotion(path, robot_, T_tip_tcp_, options_); }

  robot::Robot robot_ = irb2400();
  Frame T_tip_tcp_ = spindleMount();
  MotionOptions options_;
};

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

/// Largest distance [m] of the joint-interpolated tool from the straight lines between neighbouring waypoints.
double denseChordError(const toolpath::ToolPath& path, const Trajectory& trajectory, const Frame& T_tip_tcp) {
  const auto tcp = [&](const JointVector& q) {
    return Vector3((denavitHartenberg(q.data()) * T_tip_tcp).translation());
  };
  const auto waypoint = [&](const TrajectoryPoint& p) {
    return Vector3(
        (path.segments[static_cast<std::size_t>(p.segment)].waypoints[static_cast<std::size_t>(p.index)].pose *
         path.T_contact_tcp)
            .translation());
  };
  double error = 0.0;
  Vector3 from = waypoint(trajectory.points.front());
  for (std::size_t i = 1; i < trajectory.points.size(); ++i) {
    const TrajectoryPoint &before = trajectory.points[i - 1], &point = trajectory.points[i];
    if (before.segment != point.segment || before.index != point.index) from = waypoint(before);
    const Vector3 line = waypoint(point) - from;
    for (int k = 0; k <= 20; ++k) {
      const Vector3 off = tcp(before.q + 0.05 * k * (point.q - before.q)) - from;
      const double u = line.norm() > 0 ? std::clamp(off.dot(line) / line.squaredNorm(), 0.0, 1.0) : 0.0;
      error = std::max(error, (off - u * line).norm());
    }
  }
  return error;
}

TEST_F(PlanMotionTest, StaysWithinTheChordTolerance) {
  Raster raster;
  raster.points = 7;  // 40 mm apart
  const auto path = rasterPath(raster);
  std::size_t points_before = 0;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    options_.chord_tolerance = tolerance;
    const MotionPlan result = plan(path);
    EXPECT_LE(result.max_chord_error, tolerance);
    EXPECT_LE(denseChordError(path, result.trajectory, T_tip_tcp_), tolerance);
    EXPECT_GT(result.trajectory.points.size(), points_before);
    points_before = result.trajectory.points.size();
  }
}

TEST_F(PlanMotionTest, ChordCheckSeesMissingPoints) {
  Raster raster;
  raster.points = 7;
  const auto path = rasterPath(raster);
  MotionPlan result = plan(path);
  Trajectory thinned;
  for (const auto& entry : waypointPoints(result.trajectory)) thinned.points.push_back(entry.second);
  EXPECT_GT(denseChordError(path, thinned, T_tip_tcp_), options_.chord_tolerance);
}

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
