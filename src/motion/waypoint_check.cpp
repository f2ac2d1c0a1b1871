// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/waypoint_check.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "scan_to_path/common/text.h"

namespace scan_to_path::motion {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One limit looked at: `share` is the margin relative to the limit, which makes margins of all kinds comparable.
struct Finding {
  Verdict verdict;
  double margin;
  double share;
  const char* unit;
  std::string reason;
  std::string remedy;
};

std::string withUnit(double value, const char* unit) { return fixed(value, 4) + (*unit != 0 ? " " : "") + unit; }

Finding jointLimit(const robot::Robot& robot, const JointVector& q, const MotionOptions& options) {
  const robot::NearestLimit nearest = robot::nearestLimit(robot, q);
  const double margin = nearest.margin - options.joint_limit_margin;
  const bool is_upper = nearest.upper - nearest.angle < nearest.angle - nearest.lower;
  const double limit =
      is_upper ? nearest.upper - options.joint_limit_margin : nearest.lower + options.joint_limit_margin;
  return {Verdict::joint_limit,
          margin,
          std::isfinite(margin) ? margin / (0.5 * (nearest.upper - nearest.lower)) : infinity,
          "rad",
          robot::limitName(robot, nearest) + " is at " + withUnit(nearest.angle, "rad") + ", limit " +
              withUnit(limit, "rad"),
          "move or turn the part, or change the tool's lead and tilt"};
}

Finding singularity(const robot::Robot& robot, const JointVector& q, const MotionOptions& options) {
  const double value = smallestSingularValue(robot, q, characteristicLength(robot));
  const double margin = value - options.singular_limit;
  return {
      Verdict::singular,
      margin,
      options.singular_limit > 0.0 ? margin / options.singular_limit : infinity,
      "",
      "smallest singular value of the Jacobian is " + fixed(value, 4) + ", limit " + fixed(options.singular_limit, 4),
      "move or turn the part, or change the tool's lead and tilt"};
}

Finding speed(const robot::Robot& robot, const Arrival& arrival, const MotionOptions& options) {
  Finding worst{Verdict::speed, infinity, infinity, "rad/s", "", ""};
  const JointVector usable = usableSpeeds(robot, options);
  for (int i = 0; i < robot.dof(); ++i) {
    const double limit = usable[i], needed = arrival.rate[i] * arrival.feed;
    if ((limit - needed) / limit >= worst.share) continue;
    worst.margin = limit - needed;
    worst.share = worst.margin / limit;
    worst.reason = robot.joints[static_cast<std::size_t>(i)].name + " needs " + withUnit(needed, "rad/s") + ", limit " +
                   withUnit(limit, "rad/s");
    worst.remedy = "lower the feed to " + withUnit(arrival.feed * limit / needed, "m/s");
  }
  if (options.least_feed_share < 1.0) {
    worst.remedy +=
        " (motion.least_feed_share allows " + withUnit(options.least_feed_share * arrival.feed, "m/s") + ")";
  }
  worst.remedy += ", or move or turn the part";
  return worst;
}

Finding jump(const robot::Robot& robot, const Arrival& arrival, const MotionOptions& options) {
  int i = 0;
  const double step = arrival.step.maxCoeff(&i), margin = options.max_joint_step - step;
  return {Verdict::jump,
          margin,
          margin / options.max_joint_step,
          "rad",
          robot.joints[static_cast<std::size_t>(i)].name + " turns by " + withUnit(step, "rad") + " at once, limit " +
              withUnit(options.max_joint_step, "rad"),
          "move or turn the part so that the arm keeps its configuration"};
}

}  // namespace

double characteristicLength(const robot::Robot& robot) {
  double length = robot.T_last_tip.translation().norm();
  for (std::size_t i = 1; i < robot.joints.size(); ++i) length += robot.joints[i].T_parent_joint.translation().norm();
  return length > 0.0 ? length : 1.0;
}

double smallestSingularValue(const robot::Robot& robot, const JointVector& q, double length) {
  auto J = robot::jacobian(robot, q);
  J.topRows<3>() /= length;
  const Eigen::Matrix<double, 6, 6> JJ = J * J.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(JJ, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(eigen.eigenvalues()[0], 0.0));
}

JointVector usableSpeeds(const robot::Robot& robot, const MotionOptions& options) {
  JointVector speeds(robot.dof());
  for (int i = 0; i < robot.dof(); ++i) {
    speeds[i] = options.speed_fraction * robot.joints[static_cast<std::size_t>(i)].max_velocity;
  }
  return speeds;
}

WaypointVerdict checkWaypoint(const robot::Robot& robot, const JointVector& q, const Arrival* arrival,
                              const MotionOptions& options) {
  const bool is_between = arrival != nullptr && arrival->nearest_limit.size() > 0 &&
                          robot::limitMargin(robot, arrival->nearest_limit) < robot::limitMargin(robot, q);
  std::vector<Finding> findings = {jointLimit(robot, is_between ? arrival->nearest_limit : q, options),
                                   singularity(robot, q, options)};
  if (arrival != nullptr) findings.push_back(jump(robot, *arrival, options));
  if (arrival != nullptr && arrival->process_on) findings.push_back(speed(robot, *arrival, options));

  WaypointVerdict verdict;
  const auto broken = std::find_if(findings.begin(), findings.end(), [](const Finding& f) { return f.margin < 0.0; });
  if (broken != findings.end()) {
    verdict.verdict = broken->verdict;
    verdict.margin = broken->margin;
    verdict.unit = broken->unit;
    verdict.reason = broken->reason;
    verdict.remedy = broken->remedy;
    return verdict;
  }
  const auto least = std::min_element(findings.begin(), findings.end(),
                                      [](const Finding& a, const Finding& b) { return a.share < b.share; });
  verdict.margin = least->margin;
  verdict.unit = least->unit;
  return verdict;
}

WaypointVerdict unreachableVerdict(const Frame& T_base_tip, const robot::Miss& miss) {
  const Vector3 p = T_base_tip.translation();
  constexpr double far = 1e-6;  // below it, only the orientation cannot be had
  const bool is_far = miss.position > far;
  WaypointVerdict verdict;
  verdict.verdict = Verdict::unreachable;
  verdict.margin = is_far ? -miss.position : -miss.rotation;
  verdict.unit = is_far ? "m" : "rad";
  verdict.reason = "flange would be at (" + fixed(p.x(), 3) + ", " + fixed(p.y(), 3) + ", " + fixed(p.z(), 3) +
                   ") m, the closest the arm comes is off by " + withUnit(-verdict.margin, verdict.unit.c_str()) +
                   ", limit " + (is_far ? "1e-7 m" : "1e-7 rad");
  verdict.remedy = "move the part nearer to the robot, or change the tool's lead and tilt";
  return verdict;
}

}  // namespace scan_to_path::motion
