// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/straight_move.h"

#include <gtest/gtest.h>

#include "motion/raster.h"
#include "support/irb2400.h"

namespace scan_to_path::motion {
namespace {

using scan_to_path::test::denavitHartenberg;
using scan_to_path::test::irb2400;
using test::spindleMount;

class StraightMoveTest : public testing::Test {
protected:
  StraightMoveTest() { q_a_ << -0.3, 0.3, 0.4, 0.1, 0.6, 0.2; }

  JointVector displaced(const Vector3& way, const Vector3& rpy) const {
    Frame T = robot::forwardKinematics(robot_, q_a_) * T_tip_tcp_;
    T.translation() += way;
    T.linear() = T.linear() * geometry::makeFrame(Vector3::Zero(), rpy).linear();
    return inverse_.solve(T * T_tip_tcp_.inverse(), q_a_).value();
  }

  /// Largest distance from the straight line, joint-interpolated, 100 samples in each piece, by other kinematics.
  double denseError(const JointVector& q_b, const std::vector<JointVector>& between) const {
    std::vector<JointVector> points = {q_a_};
    points.insert(points.end(), between.begin(), between.end());
    points.push_back(q_b);
    const auto tcp = [this](const JointVector& q) {
      return Vector3((denavitHartenberg(q.data()) * T_tip_tcp_).translation());
    };
    const Vector3 a = tcp(q_a_), line = (tcp(q_b) - a).normalized();
    double error = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      for (int k = 0; k <= 100; ++k) {
        const Vector3 off = tcp(points[i - 1] + 0.01 * k * (points[i] - points[i - 1])) - a;
        error = std::max(error, (off - line * line.dot(off)).norm());
      }
    }
    return error;
  }

  robot::Robot robot_ = irb2400();
  robot::InverseKinematics inverse_{robot_};
  Frame T_tip_tcp_ = spindleMount();
  JointVector q_a_{6};
};

TEST_F(StraightMoveTest, StaysWithinEveryTolerance) {
  const JointVector q_b = displaced({0.05, 0.25, -0.08}, {0.1, -0.15, 0.2});
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const MoveSolver solver{robot_, inverse_, T_tip_tcp_, tolerance, 0.5};
    const StraightMove move = straightMove(solver, q_a_, q_b);
    EXPECT_LE(move.chord_error, tolerance);
    EXPECT_LE(denseError(q_b, move.between), tolerance);
    // Error falls with the square of the number of pieces, which is at most twice what is needed, and needed it is.
    EXPECT_GT(denseError(q_b, {}), 1e-3);
    EXPECT_LE(move.between.size() + 1.0, 2.0 * 2.0 * std::ceil(std::sqrt(denseError(q_b, {}) / tolerance)));
  }
}

TEST_F(StraightMoveTest, ReportsWhatItLeaves) {
  const JointVector q_b = displaced({0.05, 0.25, -0.08}, {0.1, -0.15, 0.2});
  const MoveSolver solver{robot_, inverse_, T_tip_tcp_, 1.0, 3.0};
  const StraightMove move = straightMove(solver, q_a_, q_b);
  EXPECT_TRUE(move.between.empty());
  // Near parabolic: the quarters see the maximum to a few percent.
  EXPECT_NEAR(move.chord_error, denseError(q_b, {}), 0.05 * move.chord_error);
}

TEST_F(StraightMoveTest, NeedsNothingForNoMove) {
  const MoveSolver solver{robot_, inverse_, T_tip_tcp_, 1e-6, 0.5};
  const StraightMove move = straightMove(solver, q_a_, q_a_);
  EXPECT_TRUE(move.between.empty());
  EXPECT_EQ(move.chord_error, 0.0);
}

TEST_F(StraightMoveTest, EndsOnAnotherConfigurationAndSaysSo) {
  const Frame T = robot::forwardKinematics(robot_, q_a_);
  const MoveSolver solver{robot_, inverse_, T_tip_tcp_, 1e-5, 0.5};
  for (const JointVector& q_b : inverse_.allConfigurations(T)) {
    if ((q_b - q_a_).norm() < 0.1 || std::abs(std::abs(q_b[5] - q_a_[5]) - 2 * M_PI) < 1e-3) continue;
    const StraightMove move = straightMove(solver, q_a_, q_b);
    EXPECT_LE(move.between.size(), 1100u);
    EXPECT_GT(move.chord_error, 1e-5);
  }
}

TEST_F(StraightMoveTest, FollowsAHalfTurnInTheSameConfiguration) {
  const MoveSolver solver{robot_, inverse_, T_tip_tcp_, 1e-5, 0.5};
  const Frame T_base_tcp = robot::forwardKinematics(robot_, q_a_) * T_tip_tcp_;
  Frame turned = T_base_tcp;
  turned.linear() = turned.linear() * geometry::makeFrame(Vector3::Zero(), {0, 0, M_PI}).linear();
  const auto knots = followMove(solver, q_a_, turned * T_tip_tcp_.inverse());
  ASSERT_GE(knots.size(), 12u);
  JointVector before = q_a_;
  for (const JointVector& q : knots) {
    EXPECT_LT((q - before).cwiseAbs().maxCoeff(), 0.5);
    EXPECT_LT(((denavitHartenberg(q.data()) * T_tip_tcp_).translation() - T_base_tcp.translation()).norm(), 1e-7);
    before = q;
  }
  EXPECT_LT((robot::forwardKinematics(robot_, knots.back()) * T_tip_tcp_).matrix().cwiseAbs().maxCoeff(), 10.0);
  const auto back = followMove(solver, knots.back(), T_base_tcp * T_tip_tcp_.inverse());
  ASSERT_FALSE(back.empty());
  EXPECT_LT((back.back() - q_a_).cwiseAbs().maxCoeff(), 1e-6);
}

TEST_F(StraightMoveTest, FollowsNothingOutOfReach) {
  const MoveSolver solver{robot_, inverse_, T_tip_tcp_, 1e-5, 0.5};
  Frame T = robot::forwardKinematics(robot_, q_a_);
  T.translation().x() += 1.5;
  robot::Miss miss;
  EXPECT_TRUE(followMove(solver, q_a_, T, &miss).empty());
  EXPECT_GT(miss.position, 0.0);
}

TEST(InterpolatePose, GoesStraightAndTurnsEvenly) {
  const Frame T = geometry::makeFrame({1, 2, 3}, {0.1, 0.2, 0.3});
  const Frame half = interpolatePose(T, {2, 0, 0}, {0, 0, 1}, 0.5);
  EXPECT_LT((half.translation() - Vector3(2, 2, 3)).norm(), 1e-15);
  EXPECT_NEAR(geometry::rotationAngle(half.linear(), T.linear()), 0.5, 1e-15);
  EXPECT_TRUE(interpolatePose(T, {2, 0, 0}, Vector3::Zero(), 1.0).linear().isApprox(T.linear(), 1e-15));
}

}  // namespace
}  // namespace scan_to_path::motion
