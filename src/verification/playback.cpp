// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/playback.h"

#include <algorithm>
#include <cmath>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <string>
#include <vector>

#include "scan_to_path/common/error.h"
#include "scan_to_path/robot/kdl_chain.h"

namespace scan_to_path::verification {
namespace {

using geometry::Vector3;
using motion::TrajectoryPoint;

/// A waypoint of the path as the robot is to reach it.
struct Target {
  WaypointIndex at;
  Frame T_base_tcp = Frame::Identity();
  bool process_on = false;
};

/// The path's waypoints in one row, with the place where each segment starts.
struct Targets {
  std::vector<Target> all;
  std::vector<std::size_t> segment_start;

  /// Place of a trajectory point's waypoint; throws InputError when the path has none such.
  std::size_t of(const TrajectoryPoint& point, std::size_t k) const {
    const auto segments = segment_start.size() - 1;
    if (point.segment >= 0 && static_cast<std::size_t>(point.segment) < segments && point.index >= 0) {
      const std::size_t place =
          segment_start[static_cast<std::size_t>(point.segment)] + static_cast<std::size_t>(point.index);
      if (place < segment_start[static_cast<std::size_t>(point.segment) + 1]) return place;
    }
    throw InputError("playback: trajectory point " + std::to_string(k) + " names segment " +
                     std::to_string(point.segment) + " index " + std::to_string(point.index) +
                     ", the path has none such");
  }
};

Targets targetsOf(const toolpath::ToolPath& path, const Frame& T_base_path) {
  Targets targets;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    targets.segment_start.push_back(targets.all.size());
    const auto& waypoints = path.segments[s].waypoints;
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
      targets.all.push_back({{static_cast<int>(s), static_cast<int>(i)},
                             T_base_path * waypoints[i].pose * path.T_contact_tcp,
                             waypoints[i].process_on});
    }
  }
  targets.segment_start.push_back(targets.all.size());
  return targets;
}

double distanceToChord(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (p - a - share * ab).norm();
}

void raise(double value, const WaypointIndex& at, double& largest, WaypointIndex& largest_at) {
  if (value <= largest) return;
  largest = value;
  largest_at = at;
}

class Player {
public:
  Player(const robot::Robot& robot, const Frame& T_tip_tcp, Targets targets)
      : dof_(robot.dof()),
        chain_(robot::kdlChain(robot)),
        forward_(chain_),
        angles_(static_cast<unsigned>(robot.dof())),
        T_tip_tcp_(T_tip_tcp),
        targets_(std::move(targets)) {}

  PlaybackReport play(const std::vector<TrajectoryPoint>& points, int between) {
    std::size_t reached_before = targets_.all.size();
    std::size_t place_before = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      checkJoints(points[k], k);
      const std::size_t place = targets_.of(points[k], k);
      if (k > 0 && place < place_before) fail(k, "goes back to an earlier waypoint");
      if (k > 0 && place > place_before) reached_before = place_before;
      const bool is_waypoint = k + 1 == points.size() || targets_.of(points[k + 1], k + 1) != place;
      // Only a move between neighbouring waypoints has a chord; after a missing one there is none.
      if (k > 0 && reached_before + 1 == place) compareMove(points[k - 1].q, points[k].q, place, between);
      if (is_waypoint) compareWaypoint(points[k].q, targets_.all[place]);
      place_before = place;
    }
    report_.missing = targets_.all.size() - report_.waypoints;
    const double count = static_cast<double>(std::max<std::size_t>(1, report_.waypoints));
    report_.position_rms = std::sqrt(report_.position_rms / count);
    report_.angle_rms = std::sqrt(report_.angle_rms / count);
    return report_;
  }

private:
  [[noreturn]] static void fail(std::size_t k, const std::string& message) {
    throw InputError("playback: trajectory point " + std::to_string(k) + " " + message);
  }

  void checkJoints(const TrajectoryPoint& point, std::size_t k) const {
    if (point.q.size() != dof_) {
      fail(k, "has " + std::to_string(point.q.size()) + " joints, the robot has " + std::to_string(dof_));
    }
    if (!point.q.allFinite()) fail(k, "has a joint angle that is not finite");
  }

  /// KDL's forward kinematics: the solver's own must not be its witness.
  Frame tcp(const robot::JointVector& q) {
    angles_.data = q;
    KDL::Frame T_base_tip;
    forward_.JntToCart(angles_, T_base_tip);
    return robot::fromKdl(T_base_tip) * T_tip_tcp_;
  }

  void compareWaypoint(const robot::JointVector& q, const Target& target) {
    const Frame T_base_tcp = tcp(q);
    const double position = (T_base_tcp.translation() - target.T_base_tcp.translation()).norm();
    const double angle = geometry::rotationAngle(target.T_base_tcp.linear(), T_base_tcp.linear());
    ++report_.waypoints;
    report_.position_rms += position * position;
    report_.angle_rms += angle * angle;
    raise(position, target.at, report_.position_largest, report_.position_largest_at);
    raise(angle, target.at, report_.angle_largest, report_.angle_largest_at);
  }

  void compareMove(const robot::JointVector& from, const robot::JointVector& to, std::size_t place, int between) {
    const Target& target = targets_.all[place];
    const Vector3 a = targets_.all[place - 1].T_base_tcp.translation();
    const Vector3 b = target.T_base_tcp.translation();
    for (int i = 1; i <= between; ++i) {
      const double share = static_cast<double>(i) / (between + 1);
      const robot::JointVector q = from + share * (to - from);
      const double off = distanceToChord(tcp(q).translation(), a, b);
      if (target.process_on) {
        raise(off, target.at, report_.chord_largest, report_.chord_largest_at);
      } else {
        raise(off, target.at, report_.air_chord_largest, report_.air_chord_largest_at);
      }
    }
  }

  int dof_;
  KDL::Chain chain_;  // the solver keeps a reference to it
  KDL::ChainFkSolverPos_recursive forward_;
  KDL::JntArray angles_;
  const Frame& T_tip_tcp_;
  Targets targets_;
  PlaybackReport report_;
};

}  // namespace

PlaybackReport playBack(const motion::Trajectory& trajectory, const robot::Robot& robot, const Frame& T_tip_tcp,
                        const toolpath::ToolPath& path, const Frame& T_base_path, int between) {
  return Player(robot, T_tip_tcp, targetsOf(path, T_base_path)).play(trajectory.points, between);
}

}  // namespace scan_to_path::verification
