// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/robot_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/robot/inverse_kinematics.h"

namespace scan_to_path::sensing {
namespace {

constexpr double node_spacing = 0.002;  // [m]
constexpr std::size_t stencil = 6;      // nodes of a fifth-degree polynomial
constexpr double most_turn = 0.2;       // of a joint between nodes [rad]: more is a jump, not a motion

struct Node {
  Frame T_base_tip;
  Vector3 p_workpiece;
  int row;
};

/// How far a configuration got along the nodes, and why no farther.
struct Attempt {
  std::vector<robot::JointVector> joints;
  std::string failure;
};

/// Newton's steps to rounding: inverse kinematics stops at 0.1 um, which neighbouring nodes would show as a kink.
robot::JointVector refined(const robot::Robot& robot, const Frame& T_base_tip, robot::JointVector q) {
  for (int step = 0; step < 2; ++step) {
    const Frame T = robot::forwardKinematics(robot, q);
    const Eigen::Matrix3d R = T_base_tip.linear() * T.linear().transpose();
    Eigen::Matrix<double, 6, 1> twist;
    twist.head<3>() = T_base_tip.translation() - T.translation();
    twist.tail<3>() = 0.5 * Vector3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
    const auto J = robot::jacobian(robot, q);
    q += J.completeOrthogonalDecomposition().solve(twist);
  }
  return q;
}

std::string limitFailure(const robot::Robot& robot, const robot::JointVector& q) {
  const robot::NearestLimit limit = robot::nearestLimit(robot, q);
  if (limit.margin >= 0.0) return {};
  return robot::limitName(robot, limit) + " is " + fixed(limit.angle, 4) + " rad, must be in [" +
         fixed(limit.lower, 4) + ", " + fixed(limit.upper, 4) + "]";
}

std::string jumpFailure(const robot::Robot& robot, const robot::JointVector& from, const robot::JointVector& to) {
  Eigen::Index joint = 0;
  const double turn = (to - from).cwiseAbs().maxCoeff(&joint);
  if (turn <= most_turn) return {};
  return robot.joints[static_cast<std::size_t>(joint)].name + " turns by " + fixed(turn, 4) +
         " rad within 2 mm, must be at most " + fixed(most_turn, 4) + " rad";
}

/// Warm start where the motion is heading.
robot::JointVector extrapolated(const std::vector<robot::JointVector>& joints) {
  if (joints.size() < 2) return joints.back();
  return 2.0 * joints.back() - joints[joints.size() - 2];
}

Attempt follow(const robot::Robot& robot, const robot::InverseKinematics& ik, const std::vector<Node>& nodes,
               const robot::JointVector& start, const Progress& progress) {
  Attempt attempt;
  for (const auto& node : nodes) {
    progress.checkCancelled();
    const bool is_first = attempt.joints.empty();
    const auto solution = ik.solve(node.T_base_tip, is_first ? start : extrapolated(attempt.joints));
    if (!solution) {
      attempt.failure = "out of the robot's reach";
      return attempt;
    }
    const robot::JointVector q = refined(robot, node.T_base_tip, *solution);
    attempt.failure = limitFailure(robot, q);
    if (attempt.failure.empty()) attempt.failure = jumpFailure(robot, is_first ? start : attempt.joints.back(), q);
    if (!attempt.failure.empty()) return attempt;
    attempt.joints.push_back(q);
  }
  return attempt;
}

[[noreturn]] void throwUnreachable(const robot::Robot& robot, const Node& node, const std::string& failure) {
  const Vector3& p = node.p_workpiece;
  throw InputError("raster row " + std::to_string(node.row) + " at x " + fixed(p.x(), 4) + ", y " + fixed(p.y(), 4) +
                   ", z " + fixed(p.z(), 4) + " m of the workpiece: " + failure + " (robot " + robot.name + ")");
}

robot::JointVector middleOfRanges(const robot::Robot& robot) {
  robot::JointVector q = robot::JointVector::Zero(robot.dof());
  for (int k = 0; k < robot.dof(); ++k) {
    const auto& joint = robot.joints[static_cast<std::size_t>(k)];
    if (std::isfinite(joint.upper - joint.lower)) q[k] = 0.5 * (joint.lower + joint.upper);
  }
  return q;
}

std::vector<robot::JointVector> followInAnyConfiguration(const robot::Robot& robot, const std::vector<Node>& nodes,
                                                         const Progress& progress) {
  const robot::InverseKinematics ik(robot);
  auto starts = ik.allConfigurations(nodes.front().T_base_tip);
  if (starts.empty()) starts.push_back(middleOfRanges(robot));  // says whether it is the reach or a joint's limit
  Attempt best;
  for (const auto& start : starts) {
    Attempt attempt = follow(robot, ik, nodes, start, progress);
    if (attempt.failure.empty()) return attempt.joints;
    if (best.failure.empty() || attempt.joints.size() > best.joints.size()) best = std::move(attempt);
  }
  throwUnreachable(robot, nodes[best.joints.size()], best.failure);
}

std::size_t nodesOf(const RasterMove& move) {
  const double intervals = std::ceil((move.to - move.from).norm() / node_spacing);
  return std::max(stencil, static_cast<std::size_t>(intervals) + 1);
}

std::vector<Node> placeNodes(const RasterPlan& plan, const Frame& T_base_workpiece, const Frame& T_tip_sensor) {
  std::vector<Node> nodes;
  const Frame T_sensor_tip = T_tip_sensor.inverse();
  Frame T_workpiece_sensor = Frame::Identity();
  T_workpiece_sensor.linear() = plan.R_workpiece_sensor;
  for (const auto& move : plan.moves) {
    const std::size_t count = nodesOf(move);
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3 p = move.from + (move.to - move.from) * (static_cast<double>(i) / static_cast<double>(count - 1));
      T_workpiece_sensor.translation() = p;
      nodes.push_back({T_base_workpiece * T_workpiece_sensor * T_sensor_tip, p, move.row});
    }
  }
  return nodes;
}

/// Lagrange weights of the nodes 0 … 5 at x.
std::array<double, stencil> lagrangeWeights(double x) {
  constexpr std::array<double, stencil> inverse_denominator = {-1.0 / 120, 1.0 / 24,  -1.0 / 12,
                                                               1.0 / 12,   -1.0 / 24, 1.0 / 120};
  std::array<double, stencil> weights;
  for (std::size_t k = 0; k < stencil; ++k) {
    double product = inverse_denominator[k];
    for (std::size_t m = 0; m < stencil; ++m) product *= m == k ? 1.0 : x - static_cast<double>(m);
    weights[k] = product;
  }
  return weights;
}

}  // namespace

RobotMotion::RobotMotion(const RasterPlan& plan, const robot::Robot& robot, const Frame& T_base_workpiece,
                         const Frame& T_tip_sensor, const Progress& progress) {
  progress.update("planning the scan", 0.0);
  nodes_ = followInAnyConfiguration(robot, placeNodes(plan, T_base_workpiece, T_tip_sensor), progress);
  std::size_t first_node = 0;
  for (const auto& move : plan.moves) {
    const std::size_t nodes = nodesOf(move);
    moves_.push_back({first_node, nodes, (move.to - move.from).norm() / static_cast<double>(nodes - 1)});
    first_node += nodes;
  }
  progress.update("planning the scan", 1.0);
}

robot::JointVector RobotMotion::jointsAt(std::size_t move, double distance) const {
  const Move& at = moves_[move];
  const double x = at.spacing > 0.0 ? distance / at.spacing : 0.0;
  const double last_start = static_cast<double>(at.nodes - stencil);
  const auto start = static_cast<std::size_t>(std::clamp(std::floor(x) - 2.0, 0.0, last_start));
  const auto weights = lagrangeWeights(x - static_cast<double>(start));
  const robot::JointVector* nodes = &nodes_[at.first_node + start];
  robot::JointVector q = weights[0] * nodes[0];
  for (std::size_t k = 1; k < stencil; ++k) q += weights[k] * nodes[k];
  return q;
}

}  // namespace scan_to_path::sensing
