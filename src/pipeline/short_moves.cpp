// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/short_moves.h"

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

/// Of all points that name a waypoint the last one is there.
bool isWaypoint(const std::vector<motion::TrajectoryPoint>& points, std::size_t i) {
  return i + 1 == points.size() || points[i + 1].segment != points[i].segment || points[i + 1].index != points[i].index;
}

std::string inMilliseconds(double time) { return fixed(1e3 * time, 3) + " ms"; }

}  // namespace

ShortMoves shortMoves(const toolpath::ToolPath& path, const motion::Trajectory& trajectory, double shortest) {
  constexpr double rounding = 1e-9;  // [s], of times that are sums of thousands of durations
  const auto& points = trajectory.points;
  std::size_t moves = 0, short_ones = 0;
  double least = shortest - rounding;
  const motion::TrajectoryPoint* before = nullptr;
  const motion::TrajectoryPoint* at = nullptr;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isWaypoint(points, i)) continue;
    const double time = before != nullptr ? points[i].time - before->time : shortest;
    moves += before != nullptr ? 1 : 0;
    before = &points[i];
    if (!(time < shortest - rounding)) continue;
    ++short_ones;
    if (!(time < least)) continue;
    least = time;
    at = &points[i];
  }
  ShortMoves found;
  found.accuracy = {{"short_moves", static_cast<double>(short_ones), "1"}};
  if (at == nullptr) return found;
  found.accuracy.push_back({"shortest_move", least, "s"});
  found.note = std::to_string(short_ones) + " of " + std::to_string(moves) + " moves last less than " +
               inMilliseconds(shortest) + " (motion.shortest_move_time), the shortest " + inMilliseconds(least) +
               ", to " + path.segments[static_cast<std::size_t>(at->segment)].name + " waypoint " +
               std::to_string(at->index) +
               ": a controller may stutter there; lower the feed, or raise path.chord_tolerance for fewer waypoints";
  return found;
}

}  // namespace scan_to_path::pipeline
