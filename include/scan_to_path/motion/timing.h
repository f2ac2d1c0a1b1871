// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace scan_to_path::motion {

/// The move to a point of the trajectory.
struct TimedMove {
  double length = 0.0;      ///< way of the tool centre point [m]
  double joint_time = 0.0;  ///< shortest duration that the joint speed limits allow [s]
  double feed = 0.0;        ///< [m/s]
  bool stop = false;        ///< whether the tool comes to rest at its end
};

/// Duration [s] of every move. The tool centre point keeps to the feed, slower where a joint would be too fast, and
/// changes its speed with constant acceleration [m/s^2] inside moves; it is at rest before the first move, after a
/// stop, and around a move that only turns. Joint accelerations and jerk are not limited. Every duration is at least
/// 2 us, so that times written to 1 us rise.
std::vector<double> moveDurations(const std::vector<TimedMove>& moves, double acceleration);

}  // namespace scan_to_path::motion
