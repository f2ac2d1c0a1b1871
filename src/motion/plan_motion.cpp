// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/plan_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/motion/driven_feed.h"
#include "scan_to_path/motion/straight_move.h"
#include "scan_to_path/motion/timing.h"
#include "scan_to_path/motion/waypoint_check.h"

namespace scan_to_path::motion {

namespace {

using robot::InverseKinematics;
using robot::Robot;

constexpr double no_length = 1e-9;  // [m]; a shorter move only turns the tool

struct Target {
  int segment;
  int index;
  Frame T_base_tip;
  double feed;
  bool process_on;
};

void checkWaypoint(const toolpath::Waypoint& waypoint, const std::string& where, bool is_first) {
  if (!waypoint.pose.matrix().allFinite()) throw InputError(where + ": pose is not finite");
  if (!is_first && !(waypoint.feed > 0.0 && std::isfinite(waypoint.feed))) {
    throw InputError(where, "feed", fixed(waypoint.feed, 6) + " m/s", "> 0 and finite");
  }
}

std::vector<Target> targets(const toolpath::ToolPath& path, const Robot& robot, const Frame& T_tip_tcp) {
  if (path.frame != robot.base_link) throw InputError("tool path", "frame", path.frame, robot.base_link);
  std::vector<Target> list;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const auto& waypoints = path.segments[s].waypoints;
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
      checkWaypoint(waypoints[i], "segment " + path.segments[s].name + " waypoint " + std::to_string(i), list.empty());
      list.push_back({static_cast<int>(s), static_cast<int>(i),
                      tipPose(waypoints[i].pose, path.T_contact_tcp, T_tip_tcp), waypoints[i].feed,
                      waypoints[i].process_on});
    }
  }
  if (list.empty()) throw InputError("tool path", "number of waypoints", "0", "> 0");
  return list;
}

/// About `count` of the indices below `size`, evenly spread, the first one among them.
std::vector<std::size_t> spread(std::size_t size, int count) {
  const std::size_t stride = (size + static_cast<std::size_t>(count) - 1) / static_cast<std::size_t>(count);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < size; i += stride) indices.push_back(i);
  return indices;
}

JointVector middleOfRanges(const Robot& robot) {
  JointVector q = JointVector::Zero(robot.dof());
  for (int i = 0; i < robot.dof(); ++i) {
    const auto& joint = robot.joints[static_cast<std::size_t>(i)];
    if (std::isfinite(joint.upper - joint.lower)) q[i] = 0.5 * (joint.lower + joint.upper);
  }
  return q;
}

/// All configurations of the first of a few targets that has any; when none has, the middle of the joint ranges.
std::vector<JointVector> candidates(const std::vector<Target>& targets, const MoveSolver& solver,
                                    const Progress& progress) {
  constexpr int tries = 100;
  for (const std::size_t i : spread(targets.size(), tries)) {
    progress.checkCancelled();
    auto found = solver.inverse.allConfigurations(targets[i].T_base_tip);
    if (!found.empty()) return found;
  }
  return {middleOfRanges(solver.robot)};
}

/// How good a configuration turned out to be; less is better.
using Score = std::tuple<int, double, double>;

/// Joint angles of the target next to q along the straight move, or anywhere; the move's knots come before them.
std::vector<JointVector> reach(const MoveSolver& solver, const JointVector& q, const Target& target, bool is_first,
                               robot::Miss* miss = nullptr) {
  std::vector<JointVector> knots;
  if (!is_first) knots = followMove(solver, q, target.T_base_tip, miss);
  if (!knots.empty()) return knots;
  if (const auto found = solver.inverse.solve(target.T_base_tip, q, miss)) knots.push_back(*found);
  return knots;
}

/// Carries a configuration along some of the targets.
Score score(const std::vector<Target>& targets, const std::vector<std::size_t>& indices, const JointVector& start,
            const MoveSolver& solver, const MotionOptions& options) {
  const Robot& robot = solver.robot;
  int failing = 0;
  double least_margin = std::numeric_limits<double>::infinity(), highest_speed = 0.0;
  const double length = characteristicLength(robot);
  JointVector q = start;
  const Target* before = nullptr;
  for (const std::size_t i : indices) {
    const std::vector<JointVector> knots = reach(solver, q, targets[i], before == nullptr);
    if (knots.empty()) {
      ++failing;
      continue;
    }
    const JointVector step = robot::largestTurns(robot, knots.size() > 1 ? knots[knots.size() - 2] : q, knots.back());
    const double margin = robot::limitMargin(robot, knots.back());
    least_margin = std::min(least_margin, margin);
    const bool is_jump = before != nullptr && step.maxCoeff() > options.max_joint_step;
    if (margin < options.joint_limit_margin || is_jump ||
        smallestSingularValue(robot, knots.back(), length) < options.singular_limit) {
      ++failing;
    }
    if (before != nullptr) {
      const double way = (targets[i].T_base_tip.translation() - before->T_base_tip.translation()).norm() /
                         static_cast<double>(knots.size());
      for (int j = 0; j < robot.dof() && way > no_length; ++j) {
        const double limit = robot.joints[static_cast<std::size_t>(j)].max_velocity;
        highest_speed = std::max(highest_speed, step[j] * targets[i].feed / way / limit);
      }
    }
    q = knots.back();
    before = &targets[i];
  }
  // Configurations that differ by whole turns differ by rounding only: they are to count as equal.
  const auto rounded = [](double value) { return std::nearbyint(value * 1e6); };
  return {failing, -rounded(least_margin), rounded(highest_speed)};
}

JointVector bestStart(const std::vector<Target>& targets, const MoveSolver& solver, const MotionOptions& options,
                      const Progress& progress) {
  const std::vector<std::size_t> indices = spread(targets.size(), options.candidate_waypoints);
  const std::vector<JointVector> starts = candidates(targets, solver, progress);
  JointVector best = starts.front();
  std::optional<Score> least;
  for (const JointVector& start : starts) {
    progress.checkCancelled();
    const Score found = score(targets, indices, start, solver, options);
    if (least && !(found < *least)) continue;
    least = found;
    best = start;
  }
  return best;
}

/// Follows the targets one by one and writes down points, verdicts and what the timing needs.
class Follower {
public:
  Follower(const MoveSolver& solver, const MotionOptions& options, const JointVector& start)
      : robot_(solver.robot),
        solver_(solver),
        options_(options),
        usable_speeds_(usableSpeeds(solver.robot, options)),
        seed_(start) {
    for (const robot::Joint& joint : robot_.joints) plan_.trajectory.joint_names.push_back(joint.name);
  }

  void follow(const Target& target) {
    robot::Miss miss;
    const bool is_first = plan_.trajectory.points.empty();
    const std::vector<JointVector> knots = reach(solver_, seed_, target, is_first, &miss);
    WaypointVerdict verdict;
    double feed = target.feed;
    if (knots.empty()) {
      verdict = unreachableVerdict(target.T_base_tip, miss);
    } else {
      const Arrival arrival = is_first ? start(target, knots.back()) : arrive(target, knots);
      verdict = motion::checkWaypoint(robot_, knots.back(), is_first ? nullptr : &arrival, options_);
      feed = arrival.feed;
      seed_ = knots.back();
    }
    verdict.segment = target.segment;
    verdict.index = target.index;
    plan_.verdicts.push_back(verdict);
    plan_.feeds.push_back(feed);
  }

  MotionPlan plan() {
    const std::vector<double> durations = moveDurations(moves_, options_.acceleration);
    double time = 0.0;
    for (std::size_t i = 0; i < durations.size(); ++i) plan_.trajectory.points[i + 1].time = time += durations[i];
    return std::move(plan_);
  }

private:
  void append(const Target& target, const JointVector& q) {
    plan_.trajectory.points.push_back({0.0, target.segment, target.index, q});
    tcp_ = (robot::forwardKinematics(robot_, q) * solver_.T_tip_tcp).translation();
  }

  Arrival start(const Target& target, const JointVector& q) {
    append(target, q);
    return {{}, {}, {}, target.feed, target.process_on};
  }

  /// The straight move from the last point along the knots.
  Arrival arrive(const Target& target, const std::vector<JointVector>& knots) {
    if (plan_.trajectory.points.back().segment != target.segment && !moves_.empty()) moves_.back().stop = true;
    const JointVector zero = JointVector::Zero(robot_.dof());
    const std::size_t first_move = moves_.size();
    Arrival arrival{{}, zero, zero, target.feed, target.process_on};
    for (const JointVector& knot : knots) {
      StraightMove move = straightMove(solver_, plan_.trajectory.points.back().q, knot);
      plan_.max_chord_error = std::max(plan_.max_chord_error, move.chord_error);
      move.between.push_back(knot);
      for (const JointVector& q : move.between) addMove(target, q, arrival);
    }
    arrival.feed = drivenFeed(robot_, arrival, options_);
    for (std::size_t i = first_move; i < moves_.size(); ++i) moves_[i].feed = arrival.feed;
    return arrival;
  }

  void addMove(const Target& target, const JointVector& q, Arrival& arrival) {
    const JointVector step = robot::largestTurns(robot_, plan_.trajectory.points.back().q, q);
    const Vector3 tcp_before = tcp_;
    append(target, q);
    const double length = (tcp_ - tcp_before).norm();
    arrival.step = arrival.step.cwiseMax(step);
    if (arrival.nearest_limit.size() == 0 ||
        robot::limitMargin(robot_, q) < robot::limitMargin(robot_, arrival.nearest_limit)) {
      arrival.nearest_limit = q;
    }
    if (length > no_length) arrival.rate = arrival.rate.cwiseMax(step / length);
    moves_.push_back({length > no_length ? length : 0.0, jointTime(step), target.feed, false});
  }

  /// Shortest duration of a step of the joints [s].
  double jointTime(const JointVector& step) const { return step.cwiseQuotient(usable_speeds_).maxCoeff(); }

  const Robot& robot_;
  const MoveSolver& solver_;
  const MotionOptions& options_;
  JointVector usable_speeds_;
  JointVector seed_;
  Vector3 tcp_ = Vector3::Zero();
  std::vector<TimedMove> moves_;
  MotionPlan plan_;
};

}  // namespace

Frame tipPose(const Frame& T_base_contact, const Frame& T_contact_tcp, const Frame& T_tip_tcp) {
  return T_base_contact * T_contact_tcp * T_tip_tcp.inverse();  // Equation (13)
}

MotionPlan planMotion(const toolpath::ToolPath& path, const Robot& robot, const Frame& T_tip_tcp,
                      const MotionOptions& options, const Progress& progress) {
  validate(options, "motion");
  const std::vector<Target> list = targets(path, robot, T_tip_tcp);
  const InverseKinematics inverse(robot);
  const MoveSolver solver{robot, inverse, T_tip_tcp, options.chord_tolerance, options.max_joint_step};
  Follower follower(solver, options, bestStart(list, solver, options, progress));
  constexpr std::size_t block = 1024;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i % block == 0) progress.update("motion", static_cast<double>(i) / static_cast<double>(list.size()));
    follower.follow(list[i]);
  }
  return follower.plan();
}

}  // namespace scan_to_path::motion
