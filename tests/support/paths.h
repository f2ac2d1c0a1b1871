// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "scan_to_path/toolpath/ball_tool.h"
#include "scan_to_path/toolpath/contact_frame.h"

namespace scan_to_path::test {

/// `rows` rows along x on the plane z = 0, `pitch` apart, each from x = 0 to `length` in `moves` moves.
inline toolpath::ToolPath planeRows(int rows, double pitch, double length, int moves, bool zig_zag = false,
                                    double ball_radius = 0.02) {
  toolpath::ToolPath path;
  path.process = "cutting";
  path.frame = "base_link";
  path.T_contact_tcp = toolpath::ballToolFrame({ball_radius, 0.0, 0.0});
  for (int row = 0; row < rows; ++row) {
    const bool back = zig_zag && row % 2 != 0;
    toolpath::Segment segment = {"row_" + std::to_string(row), {}};
    for (int i = 0; i <= moves; ++i) {
      const double x = length * (back ? moves - i : i) / moves;
      toolpath::Waypoint waypoint;
      waypoint.pose = toolpath::contactFrame({x, row * pitch, 0.0}, {0.0, 0.0, 1.0}, {back ? -1.0 : 1.0, 0.0, 0.0});
      waypoint.feed = 0.02;
      waypoint.process_on = i > 0;
      segment.waypoints.push_back(waypoint);
    }
    path.segments.push_back(segment);
  }
  return toolpath::withArcLength(path);
}

/// The path moved rigidly.
inline toolpath::ToolPath moved(toolpath::ToolPath path, const geometry::Frame& T) {
  for (auto& segment : path.segments) {
    for (auto& waypoint : segment.waypoints) waypoint.pose = T * waypoint.pose;
  }
  return path;
}

/// The largest difference of two paths' poses, in metres and in the rotations' elements; infinite when the paths
/// differ in segments, feeds or process_on.
inline double largestDifference(const toolpath::ToolPath& a, const toolpath::ToolPath& b) {
  const double different = std::numeric_limits<double>::infinity();
  if (a.segments.size() != b.segments.size() || a.process != b.process) return different;
  double largest = (a.T_contact_tcp.matrix() - b.T_contact_tcp.matrix()).cwiseAbs().maxCoeff();
  for (std::size_t s = 0; s < a.segments.size(); ++s) {
    const auto& left = a.segments[s];
    const auto& right = b.segments[s];
    if (left.name != right.name || left.waypoints.size() != right.waypoints.size()) return different;
    for (std::size_t i = 0; i < left.waypoints.size(); ++i) {
      const auto& p = left.waypoints[i];
      const auto& q = right.waypoints[i];
      if (std::abs(p.feed - q.feed) > 1e-9 || p.process_on != q.process_on) return different;
      largest = std::max(largest, (p.pose.matrix() - q.pose.matrix()).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

}  // namespace scan_to_path::test
