// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/playback.h"

#include <gtest/gtest.h>
#include <tf2_eigen/tf2_eigen.h>

#include <cmath>

#include "support/expect_input_error.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;

const ros::Time begin_time(10.0);

trajectory_msgs::JointTrajectory trajectory() {
  trajectory_msgs::JointTrajectory msg;
  msg.joint_names = {"joint_1", "joint_2"};
  for (const double time : {0.0, 0.1, 0.5}) {
    trajectory_msgs::JointTrajectoryPoint point;
    point.positions = {time, -2.0 * time};
    point.time_from_start = ros::Duration(time);
    msg.points.push_back(point);
  }
  return msg;
}

/// A path of one segment whose waypoints are the trajectory's points.
core::toolpath::ToolPath path() {
  core::toolpath::ToolPath path;
  path.process = "cutting";
  path.frame = "base_link";
  path.T_contact_tcp = core::geometry::makeFrame({0, 0, 0.01}, {M_PI, 0, 0});
  path.segments.push_back({"row_0", {}});
  for (int i = 0; i < 3; ++i) {
    core::toolpath::Waypoint waypoint;
    waypoint.pose = core::geometry::makeFrame({0.1 * i, 0.2, 0.3}, {0.1, 0.2, 0.3 * i});
    path.segments[0].waypoints.push_back(waypoint);
  }
  return path;
}

core::MotionPlan plan() {
  core::MotionPlan plan;
  plan.segment = {0, 0, 0};
  plan.index = {0, 1, 2};
  return plan;
}

/// Where tf2 says the tool was at waypoint i, `off` metres beside where it should be.
geometry_msgs::TransformStamped tool(const JointPlayback& playback, int i, double off) {
  auto T = path().segments[0].waypoints[static_cast<std::size_t>(i)].pose * path().T_contact_tcp;
  T.translation().x() += off;
  geometry_msgs::TransformStamped msg = tf2::eigenToTransform(T);
  msg.header.frame_id = "base_link";
  msg.header.stamp = playback.stamp(static_cast<std::size_t>(i));
  msg.child_frame_id = "tcp";
  return msg;
}

TEST(JointPlayback, PlaysEveryPointAtItsTimeAndStraightInJointsBetween) {
  PlaybackOptions options;
  options.speed = 2.0;
  JointPlayback playback(trajectory(), options, begin_time);
  EXPECT_EQ(playback.stamp(2), begin_time + ros::Duration(0.25));
  std::size_t states = 0;
  for (int tick = 0; tick <= 25; ++tick) {
    for (const auto& state : playback.until(begin_time + ros::Duration(0.01 * tick + 1e-6))) {
      ++states;
      const double at = options.speed * (state.header.stamp - begin_time).toSec();
      EXPECT_NEAR(state.position[0], at, 1e-8);  // stamps count nanoseconds, played at twice the speed
      EXPECT_NEAR(state.position[1], -2.0 * at, 1e-8);
    }
  }
  EXPECT_TRUE(playback.isDone());
  EXPECT_EQ(playback.fraction(), 1.0);
  EXPECT_EQ(states, 1U + 3U + 10U);  // 50 states a second at least
  EXPECT_EQ(playback.last().position[0], 0.5);
}

TEST(JointPlayback, RefusesWhatCannotBePlayed) {
  const auto refused = [](auto change, const std::string& why) {
    auto msg = trajectory();
    PlaybackOptions options;
    change(msg, options);
    core::test::expectInputError([&] { JointPlayback(msg, options, begin_time); }, why);
  };
  refused([](auto& msg, auto&) { msg.points.clear(); }, "no points");
  refused([](auto& msg, auto&) { msg.points[1].positions.pop_back(); }, "point 1 has 1 positions of 2 joints");
  refused([](auto& msg, auto&) { msg.points[2].positions[0] = std::nan(""); }, "point 2 has a position");
  refused([](auto& msg, auto&) { msg.points[2].time_from_start = ros::Duration(0.1); }, "point 2 is not later");
  refused([](auto&, auto& options) { options.speed = 0.0; }, "speed");
  refused([](auto&, auto& options) { options.rate = 0.0; }, "rate");
}

TEST(PlaybackComparison, FindsTheLargestDeviationAndWhereItIs) {
  const JointPlayback playback(trajectory(), {}, begin_time);
  PlaybackComparison comparison(path(), plan(), playback);
  for (int i = 0; i < 3; ++i) comparison.addTransform(tool(playback, i, i == 1 ? 1.5e-6 : 0.0), false);
  comparison.finish();
  EXPECT_EQ(comparison.deviation().waypoints, 3U);
  EXPECT_EQ(comparison.deviation().missing, 0U);
  EXPECT_NEAR(comparison.deviation().position_largest, 1.5e-6, 1e-12);
  EXPECT_EQ(comparison.deviation().position_index, 1);
  EXPECT_LT(comparison.deviation().angle_largest, 1e-12);
  EXPECT_EQ(comparison.path().poses.size(), 3U);
}

TEST(PlaybackComparison, CountsWaypointsThatWereNotPlayed) {
  const JointPlayback playback(trajectory(), {}, begin_time);
  PlaybackComparison comparison(path(), plan(), playback);
  comparison.addTransform(tool(playback, 0, 0.0), false);
  EXPECT_EQ(comparison.waiting(), 2U);
  comparison.finish();
  EXPECT_EQ(comparison.deviation().missing, 2U);
  auto other = plan();
  other.index[2] = 7;
  core::test::expectInputError([&] { PlaybackComparison(path(), other, playback); }, "index 7, the path has none");
}

TEST(PlaybackComparison, GoesOnAfterAWaypointThatWasNotSeen) {
  PlaybackOptions options;
  for (const double speed : {1.0, 0.1}) {  // waypoints at 0, 0.1 and 0.5 s; ten times as far apart
    options.speed = speed;
    const JointPlayback playback(trajectory(), options, begin_time);
    PlaybackComparison comparison(path(), plan(), playback);
    comparison.addTransform(tool(playback, 1, 0.0), false);
    EXPECT_EQ(comparison.waiting(), 3U);  // the first may be late
    comparison.addTransform(tool(playback, 2, 2e-6), false);
    EXPECT_EQ(comparison.waiting(), speed < 1.0 ? 0U : 3U);
    comparison.finish();
    EXPECT_EQ(comparison.deviation().missing, 1U);
    EXPECT_EQ(comparison.deviation().waypoints, 2U);
    EXPECT_NEAR(comparison.deviation().position_largest, 2e-6, 1e-12);
  }
}

}  // namespace
}  // namespace scan_to_path_ros
