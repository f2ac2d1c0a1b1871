// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/straight_move.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_to_path::motion {

namespace {

constexpr int max_halvings = 10;
constexpr double largest_turn = 0.25;  // [rad]
constexpr double largest_way = 0.1;    // [m]
// A piece's error is near parabolic; its maximum lies that little above the samples at the quarters.
constexpr double accepted_share = 0.95;

double distanceFromLine(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 line = b - a;
  const double squared = line.squaredNorm();
  const double u = squared > 0.0 ? std::clamp((p - a).dot(line) / squared, 0.0, 1.0) : 0.0;
  return (p - a - u * line).norm();
}

Frame toolPose(const MoveSolver& solver, const JointVector& q) {
  return robot::forwardKinematics(solver.robot, q) * solver.T_tip_tcp;
}

Eigen::Matrix3d rotation(const Vector3& turn) {
  const double angle = turn.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
}

/// Joint angles of evenly spaced poses on the way from a to b; empty when one has none.
std::vector<JointVector> followTurn(const MoveSolver& solver, const JointVector& q_a, const Frame& T_base_a,
                                    const Frame& T_base_b, const Vector3& turn, robot::Miss* miss) {
  const Frame T_tcp_tip = solver.T_tip_tcp.inverse();
  const Vector3 way = T_base_b.translation() - T_base_a.translation();
  const int steps =
      std::max(1, static_cast<int>(std::ceil(std::max(turn.norm() / largest_turn, way.norm() / largest_way))));
  std::vector<JointVector> knots;
  for (int k = 1; k <= steps; ++k) {
    const Frame T_base_tcp =
        k == steps ? T_base_b : interpolatePose(T_base_a, way, turn, static_cast<double>(k) / steps);
    const auto q = solver.inverse.solve(T_base_tcp * T_tcp_tip, knots.empty() ? q_a : knots.back(), miss);
    if (!q) return {};
    knots.push_back(*q);
  }
  return knots;
}

/// Squared distances from the middle of the joint ranges, relative to half the range.
double distanceFromMiddle(const robot::Robot& robot, const JointVector& q) {
  double sum = 0.0;
  for (int i = 0; i < robot.dof(); ++i) {
    const robot::Joint& joint = robot.joints[static_cast<std::size_t>(i)];
    const double half = 0.5 * (joint.upper - joint.lower);
    if (std::isfinite(half)) sum += std::pow((q[i] - joint.lower - half) / half, 2);
  }
  return sum;
}

double leastMargin(const robot::Robot& robot, const std::vector<JointVector>& knots) {
  double least = std::numeric_limits<double>::infinity();
  for (const JointVector& q : knots) least = std::min(least, robot::limitMargin(robot, q));
  return least;
}

/// Whether way a keeps within the limits where b does not, or else ends nearer to the middle of the joint ranges.
/// Rounding must not decide between equal ones.
bool isPreferred(const robot::Robot& robot, const std::vector<JointVector>& a, const std::vector<JointVector>& b) {
  const bool a_is_within = leastMargin(robot, a) >= 0.0, b_is_within = leastMargin(robot, b) >= 0.0;
  if (a_is_within != b_is_within) return a_is_within;
  constexpr double same = 1e-6;
  const double difference = distanceFromMiddle(robot, a.back()) - distanceFromMiddle(robot, b.back());
  return std::abs(difference) > same ? difference < 0.0 : a.back().tail<1>()[0] < b.back().tail<1>()[0];
}

/// One straight move and its pieces so far.
class Halving {
public:
  Halving(const MoveSolver& solver, const JointVector& q_a, const JointVector& q_b)
      : solver_(solver),
        T_tcp_tip_(solver.T_tip_tcp.inverse()),
        T_base_a_(toolPose(solver, q_a)),
        b_(toolPose(solver, q_b).translation()) {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(toolPose(solver, q_b).linear() * T_base_a_.linear().transpose()));
    turn_ = turn.angle() * turn.axis();
  }

  void halve(const JointVector& q_0, double u_0, const JointVector& q_1, double u_1, int halvings) {
    const double error = chordError(solver_, q_0, q_1, T_base_a_.translation(), b_);
    const bool is_fine =
        error <= accepted_share * solver_.tolerance && (q_1 - q_0).cwiseAbs().maxCoeff() <= solver_.largest_step;
    if (!is_fine && halvings < max_halvings) {
      const double u = 0.5 * (u_0 + u_1);
      const Frame T_base_tcp = interpolatePose(T_base_a_, b_ - T_base_a_.translation(), turn_, u);
      const auto q = solver_.inverse.solve(T_base_tcp * T_tcp_tip_, 0.5 * (q_0 + q_1));
      if (q && isBetween(*q, q_0, q_1)) {
        halve(q_0, u_0, *q, u, halvings + 1);
        move_.between.push_back(*q);
        return halve(*q, u, q_1, u_1, halvings + 1);
      }
    }
    move_.chord_error = std::max(move_.chord_error, error);
  }

  StraightMove move() { return std::move(move_); }

private:
  /// Whether q is about as near to both neighbours as they are to each other, and so no other configuration.
  static bool isBetween(const JointVector& q, const JointVector& q_0, const JointVector& q_1) {
    const double apart = (q_1 - q_0).norm() + 0.02;
    return (q - q_0).norm() <= apart && (q - q_1).norm() <= apart;
  }

  const MoveSolver& solver_;
  Frame T_tcp_tip_, T_base_a_;
  Vector3 b_, turn_;
  StraightMove move_;
};

}  // namespace

Frame interpolatePose(const Frame& T, const Vector3& way, const Vector3& turn, double u) {
  Frame between = Frame::Identity();
  between.translation() = T.translation() + u * way;
  between.linear() = rotation(u * turn) * T.linear();
  return between;
}

std::vector<JointVector> followMove(const MoveSolver& solver, const JointVector& q_a, const Frame& T_base_tip,
                                    robot::Miss* miss) {
  const Frame T_base_a = toolPose(solver, q_a), T_base_b = T_base_tip * solver.T_tip_tcp;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(T_base_b.linear() * T_base_a.linear().transpose()));
  const auto one_way = followTurn(solver, q_a, T_base_a, T_base_b, turn.angle() * turn.axis(), miss);
  if (turn.angle() < M_PI - largest_turn) return one_way;
  const auto other_way = followTurn(solver, q_a, T_base_a, T_base_b, (turn.angle() - 2.0 * M_PI) * turn.axis(), miss);
  if (one_way.empty() || other_way.empty()) return one_way.empty() ? other_way : one_way;
  return isPreferred(solver.robot, one_way, other_way) ? one_way : other_way;
}

double chordError(const MoveSolver& solver, const JointVector& q_a, const JointVector& q_b, const Vector3& a,
                  const Vector3& b) {
  double error = 0.0;
  for (const double u : {0.25, 0.5, 0.75}) {
    const JointVector q = (1.0 - u) * q_a + u * q_b;
    error = std::max(error, distanceFromLine(toolPose(solver, q).translation(), a, b));
  }
  return error;
}

StraightMove straightMove(const MoveSolver& solver, const JointVector& q_a, const JointVector& q_b) {
  Halving halving(solver, q_a, q_b);
  halving.halve(q_a, 0.0, q_b, 1.0, 0);
  return halving.move();
}

}  // namespace scan_to_path::motion
