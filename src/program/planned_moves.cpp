// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "planned_moves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/program/blend_zone.h"
#include "scan_to_path/program/rapid_names.h"

namespace scan_to_path::program {
namespace {

/// Zones that a program uses [m]: the radius is rounded down to one of them, below the first the robot stops.
constexpr std::array<double, 12> zone_steps = {10e-6, 20e-6, 50e-6, 100e-6, 200e-6, 500e-6,
                                               1e-3,  2e-3,  5e-3,  10e-3,  20e-3,  50e-3};

/// A controller takes targets within its reach; beyond this the input is not a robot's path.
constexpr double largest_coordinate = 100.0;

/// Joint angles per waypoint: of all trajectory points that carry its numbers the last is the waypoint itself.
class JointTable {
public:
  explicit JointTable(const ProgramInput& input) {
    for (const auto& segment : input.path.segments) table_.emplace_back(segment.waypoints.size(), nullptr);
    for (const auto& point : input.plan.trajectory.points) {
      if (point.segment < 0 || point.segment >= static_cast<int>(table_.size()) || point.index < 0 ||
          point.index >= static_cast<int>(table_[point.segment].size())) {
        throw InputError("trajectory point for segment " + std::to_string(point.segment) + " waypoint " +
                         std::to_string(point.index) + ": the path has no such waypoint");
      }
      table_[point.segment][point.index] = &point.q;
    }
  }

  const JointVector* find(int segment, int index) const { return table_[segment][index]; }

private:
  std::vector<std::vector<const JointVector*>> table_;
};

void checkFrame(const Frame& T, const std::string& where) {
  if (!T.matrix().allFinite()) throw InputError(where, "pose", "not finite", "finite");
  const double skew = (T.linear().transpose() * T.linear() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (skew > 1e-6 || T.linear().determinant() < 0.0) {
    throw InputError(where, "rotation", "off orthogonal by " + fixed(skew, 9), "a right-handed rotation within 1e-6");
  }
  const double reach = T.translation().cwiseAbs().maxCoeff();
  if (reach > largest_coordinate) {
    throw InputError(where, "coordinate", fixed(reach, 3) + " m", "within " + fixed(largest_coordinate, 0) + " m");
  }
}

/// The signal stays off in an air run's program: that goes with a path off the part, and only with one.
void checkLift(const ProgramInput& input) {
  const double lift = input.path.lift.norm();
  if (std::abs(lift - input.options.dry_offset) <= 1e-9) return;  // rounding of a direction of length one
  throw InputError("robot program", "lift of the path", fixed(1e3 * lift, 6) + " mm",
                   fixed(1e3 * input.options.dry_offset, 6) + " mm (program.dry_offset)");
}

void checkJoints(const ProgramInput& input, const JointVector& q, const std::string& where) {
  if (q.size() != input.robot.dof()) {
    throw InputError(where, "number of joint angles", std::to_string(q.size()), std::to_string(input.robot.dof()));
  }
  if (!q.allFinite()) throw InputError(where, "joint angle", "not finite", "finite");
}

/// The read-back refuses the same by itself: it is a witness only as long as it trusts nothing that the writer checked,
/// and takes its feeds from the same plan.
void checkFeedCount(const ProgramInput& input) {
  const std::size_t feeds = input.plan.feeds.size(), waypoints = toolpath::waypointCount(input.path);
  if (feeds == waypoints) return;
  throw InputError("motion plan", "number of feeds", std::to_string(feeds),
                   "one for each of " + std::to_string(waypoints) + " waypoints");
}

/// `asked`: the path's feed, which the motion may lower but not raise.
void checkFeed(const ProgramInput& input, double feed, double asked, const std::string& where) {
  // Speeds are written to 1e-6 m/s; anything slower would read as a standstill.
  if (!(feed >= 1e-6 && feed <= input.options.max_speed)) {
    throw InputError(where, "feed", std::isfinite(feed) ? fixed(feed, 6) + " m/s" : "not finite",
                     "in [0.000001, " + fixed(input.options.max_speed, 3) + "] m/s (program.max_speed)");
  }
  if (!(feed <= asked)) {
    throw InputError(where, "feed", fixed(feed, 6) + " m/s", "at most the path's " + fixed(asked, 6) + " m/s");
  }
}

double roundedDown(double radius) {
  // A radius that is a step but for rounding is that step, on every machine.
  const auto above = std::upper_bound(zone_steps.begin(), zone_steps.end(), radius * (1.0 + 1e-9));
  return above == zone_steps.begin() ? 0.0 : *(above - 1);
}

/// Stops at the ends of segments and where the process is switched (a program runs ahead of the arm, so that only a
/// stop ties a switch to a place); blends within the tolerance elsewhere.
void setZones(const ProgramInput& input, std::vector<PlannedMove>& moves) {
  for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
    const auto& next = moves[i + 1];
    if (next.segment != moves[i].segment || next.process_on != moves[i].process_on) continue;
    const double tolerance = next.process_on ? input.options.zone_tolerance : input.options.air_tolerance;
    const double radius =
        blendRadius(moves[i - 1].T_workobject_tcp.translation(), moves[i].T_workobject_tcp.translation(),
                    next.T_workobject_tcp.translation(), tolerance);
    moves[i].zone = roundedDown(radius);
  }
}

/// What works in a segment runs before the tool comes down to it and until the tool has left it: a tool that stands
/// still must not touch the part, nor dwell on it while it speeds up.
bool processRuns(const toolpath::Segment& segment) {
  return std::any_of(segment.waypoints.begin(), segment.waypoints.end(),
                     [](const auto& waypoint) { return waypoint.process_on; });
}

}  // namespace

std::string waypointLabel(const toolpath::ToolPath& path, int segment, int index) {
  return "segment " + asciiLine(path.segments[segment].name) + " (" + std::to_string(segment) + ") waypoint " +
         std::to_string(index);
}

std::vector<PlannedMove> plannedMoves(const ProgramInput& input) {
  checkFrame(input.T_base_path, "frame of the path");
  checkFrame(input.path.T_contact_tcp, "T_contact_tcp of the path");
  checkFrame(input.T_tip_tcp, "tool mount");
  checkFrame(input.T_base_workobject, "work object");
  checkLift(input);
  checkFeedCount(input);
  const JointTable joints(input);
  const Frame T_workobject_path = input.T_base_workobject.inverse() * input.T_base_path;
  std::vector<PlannedMove> moves;
  moves.reserve(input.plan.trajectory.points.size());
  for (int s = 0; s < static_cast<int>(input.path.segments.size()); ++s) {
    const auto& waypoints = input.path.segments[s].waypoints;
    const bool process_on = processRuns(input.path.segments[s]);
    for (int i = 0; i < static_cast<int>(waypoints.size()); ++i) {
      const std::string where = waypointLabel(input.path, s, i);
      checkFrame(waypoints[i].pose, where);
      const JointVector* q = joints.find(s, i);
      if (q == nullptr) throw InputError(where, "joint solution", "missing", "there");
      checkJoints(input, *q, where);
      const bool first = moves.empty();
      const double feed = input.plan.feeds[moves.size()];
      if (!first) checkFeed(input, feed, waypoints[i].feed, where);
      if (first && waypoints[i].process_on) {
        throw InputError(where, "process", "on", "off at the path's first waypoint, which an axis move reaches");
      }
      moves.push_back({s, i, T_workobject_path * waypoints[i].pose * input.path.T_contact_tcp, *q,
                       first ? input.options.start_speed : feed, process_on && !first, 0.0});
    }
  }
  if (moves.empty()) throw InputError("robot program: the path has no waypoint");
  setZones(input, moves);
  return moves;
}

}  // namespace scan_to_path::program
