// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/playback.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_input_error.h"
#include "support/irb2400.h"
#include "support/paths.h"

namespace scan_to_path::verification {
namespace {

using motion::Trajectory;
using robot::JointVector;

/// A path made from joint angles by the arm's published dimensions, so that the right trajectory is known.
struct World {
  robot::Robot robot = test::irb2400();
  Frame T_tip_tcp = geometry::makeFrame({0.0, 0.03, 0.2}, {0.1, 0.2, 0.3});
  Frame T_base_path = geometry::makeFrame({0.4, -0.2, 0.3}, {0.0, 0.3, 1.0});
  toolpath::ToolPath path = test::planeRows(3, 0.004, 0.1, 6);
  Trajectory trajectory;

  World() {
    path.T_contact_tcp = toolpath::ballToolFrame({0.02, 0.1, 0.0});
    JointVector q(6);
    q << 0.1, 0.2, 0.1, 0.3, 0.6, -0.2;
    for (std::size_t s = 0; s < path.segments.size(); ++s) {
      for (std::size_t i = 0; i < path.segments[s].waypoints.size(); ++i) {
        q.array() += 0.01;
        const Frame T_base_tip = test::denavitHartenberg(q.data());
        path.segments[s].waypoints[i].pose =
            T_base_path.inverse() * T_base_tip * T_tip_tcp * path.T_contact_tcp.inverse();
        trajectory.points.push_back({0.0, static_cast<int>(s), static_cast<int>(i), q});
      }
    }
  }

  PlaybackReport play(int between = 8) const {
    return playBack(trajectory, robot, T_tip_tcp, path, T_base_path, between);
  }
};

TEST(Playback, OfTheRightTrajectoryIsOnThePath) {
  const auto report = World().play();
  EXPECT_EQ(report.waypoints, 21U);
  EXPECT_EQ(report.missing, 0U);
  // Rounding of some twenty products of transforms at 2 m of reach.
  EXPECT_LT(report.position_largest, 1e-13);
  EXPECT_LT(report.angle_largest, 1e-13);
}

TEST(Playback, ShowsAJointThatIsOff) {
  World world;
  world.trajectory.points[9].q[0] += 1e-4;
  const auto report = world.play();
  EXPECT_EQ(report.position_largest_at.segment, 1);
  EXPECT_EQ(report.position_largest_at.index, 2);
  EXPECT_NEAR(report.angle_largest, 1e-4, 1e-10);
  const auto tip = robot::forwardKinematics(world.robot, world.trajectory.points[9].q) * world.T_tip_tcp;
  EXPECT_NEAR(report.position_largest, 1e-4 * tip.translation().head<2>().norm(), 1e-8);
  EXPECT_NEAR(report.position_rms, report.position_largest / std::sqrt(21.0), 1e-9);
}

TEST(Playback, MeasuresTheChordsOfJointLinearMoves) {
  const World world;
  const auto report = world.play(1);
  double widest = 0.0;
  for (std::size_t k = 1; k < world.trajectory.points.size(); ++k) {
    const auto& to = world.trajectory.points[k];
    if (!world.path.segments[static_cast<std::size_t>(to.segment)]
             .waypoints[static_cast<std::size_t>(to.index)]
             .process_on)
      continue;
    const auto& from = world.trajectory.points[k - 1];
    const auto tcp = [&](const JointVector& q) {
      return geometry::Vector3((test::denavitHartenberg(q.data()) * world.T_tip_tcp).translation());
    };
    const geometry::Vector3 a = tcp(from.q), b = tcp(to.q), m = tcp(0.5 * (from.q + to.q));
    widest = std::max(widest, (m - a).cross(b - a).norm() / (b - a).norm());
  }
  EXPECT_NEAR(report.chord_largest, widest, 1e-12);
  EXPECT_GT(widest, 1e-6);
  EXPECT_GE(world.play(9).chord_largest, report.chord_largest);
}

TEST(Playback, PointsBetweenWaypointsBelongToTheMove) {
  World world;
  auto& points = world.trajectory.points;
  const double coarse = world.play().chord_largest;
  // Two points in joint space on every move change nothing at waypoints, and nothing of the joint-linear move.
  std::vector<motion::TrajectoryPoint> finer;
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (int j = 1; k > 0 && j < 3; ++j) {
      motion::TrajectoryPoint between = points[k];
      between.q = points[k - 1].q + j / 3.0 * (points[k].q - points[k - 1].q);
      finer.push_back(between);
    }
    finer.push_back(points[k]);
  }
  points = finer;
  const auto report = world.play();
  EXPECT_EQ(report.waypoints, 21U);
  EXPECT_LT(report.position_largest, 1e-13);
  EXPECT_NEAR(report.chord_largest, coarse, 0.1 * coarse);
  // Twin: a point beside the move shows in the chord, not at the waypoints.
  points[7].q[1] += 1e-3;
  EXPECT_GT(world.play().chord_largest, 5e-4);
  EXPECT_LT(world.play().position_largest, 1e-13);
}

TEST(Playback, CountsWhatIsMissing) {
  World world;
  world.trajectory.points.erase(world.trajectory.points.begin() + 5);
  const auto report = world.play();
  EXPECT_EQ(report.waypoints, 20U);
  EXPECT_EQ(report.missing, 1U);
  EXPECT_LT(report.position_largest, 1e-13);
  world.trajectory.points.clear();
  EXPECT_EQ(world.play().missing, 21U);
}

TEST(Playback, NoticesAWrongToolOrPathFrame) {
  World world;
  world.T_tip_tcp = geometry::makeFrame({0.0, 0.03, 0.2001}, {0.1, 0.2, 0.3});
  EXPECT_NEAR(world.play().position_largest, 1e-4, 1e-10);
  World other;
  other.T_base_path = Frame::Identity();
  EXPECT_GT(other.play().position_largest, 0.1);
}

TEST(Playback, RejectsTrajectoriesOfAnotherPath) {
  World world;
  world.trajectory.points[3].segment = 7;
  test::expectInputError([&] { world.play(); }, "trajectory point 3 names segment 7");
  world.trajectory.points[3].segment = 0;
  world.trajectory.points[3].index = 0;
  test::expectInputError([&] { world.play(); }, "trajectory point 3 goes back");
  World short_one;
  short_one.trajectory.points[2].q = JointVector::Zero(5);
  test::expectInputError([&] { short_one.play(); }, "trajectory point 2 has 5 joints, the robot has 6");
}

}  // namespace
}  // namespace scan_to_path::verification
