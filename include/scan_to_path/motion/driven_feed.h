// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/motion/waypoint_check.h"

namespace scan_to_path::motion {

/// The feed [m/s] that the move to a waypoint is driven at: the one asked for, where the process is off and wherever no
/// joint is then too fast.
///
/// Else the fastest at which none is of those that are 5 % apart, from the feed asked for down to least_feed_share of
/// it, each rounded down to 1e-6 m/s, the last digit of programs. Steps keep the feeds of a path few: 28 down to a
/// quarter, where every waypoint would have a feed of its own, and thousands of them had to be declared in a program. A
/// step costs 5 % of the speed at most.
///
/// Where even the last step is too fast the feed asked for comes back, for checkWaypoint to say so.
double drivenFeed(const robot::Robot& robot, const Arrival& arrival, const MotionOptions& options);

}  // namespace scan_to_path::motion
