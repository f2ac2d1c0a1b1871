// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/timing.h"

#include <algorithm>
#include <cmath>

namespace scan_to_path::motion {

namespace {

constexpr double shortest_move = 2e-6;  // [s]

/// Highest speed of the tool centre point during a move; 0 for a pure turn.
double speedLimit(const TimedMove& move) {
  return move.joint_time > 0.0 ? std::min(move.feed, move.length / move.joint_time) : move.feed;
}

/// Speed at the end of every move, reachable from the one before and slow enough for what follows.
std::vector<double> endSpeeds(const std::vector<TimedMove>& moves, double acceleration) {
  const std::size_t n = moves.size();
  std::vector<double> speeds(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool at_rest = i + 1 == n || moves[i].stop;
    speeds[i] = at_rest ? 0.0 : std::min(speedLimit(moves[i]), speedLimit(moves[i + 1]));
  }
  double before = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    before = speeds[i] = std::min(speeds[i], std::sqrt(before * before + 2.0 * acceleration * moves[i].length));
  }
  for (std::size_t i = n; i-- > 1;) {
    speeds[i - 1] = std::min(speeds[i - 1], std::sqrt(speeds[i] * speeds[i] + 2.0 * acceleration * moves[i].length));
  }
  return speeds;
}

/// Accelerates from v0, holds the highest speed the length allows, brakes to v1.
double duration(const TimedMove& move, double v0, double v1, double acceleration) {
  const double limit = speedLimit(move);
  if (!(limit > 0.0) || move.length == 0.0) return move.joint_time;
  const double squares = 0.5 * (v0 * v0 + v1 * v1);
  const double peak = std::max({v0, v1, std::min(limit, std::sqrt(squares + acceleration * move.length))});
  const double ramps = (peak * peak - squares) / acceleration;  // [m]
  return (2.0 * peak - v0 - v1) / acceleration + std::max(move.length - ramps, 0.0) / peak;
}

}  // namespace

std::vector<double> moveDurations(const std::vector<TimedMove>& moves, double acceleration) {
  const std::vector<double> speeds = endSpeeds(moves, acceleration);
  std::vector<double> durations(moves.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const double v0 = i == 0 ? 0.0 : speeds[i - 1];
    durations[i] = std::max({duration(moves[i], v0, speeds[i], acceleration), moves[i].joint_time, shortest_move});
  }
  return durations;
}

}  // namespace scan_to_path::motion
