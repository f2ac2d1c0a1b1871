// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "scan_to_path/robot/robot.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::motion::test {

using geometry::Frame;
using geometry::Vector3;

/// A tool 0.2 m long, tilted as a spindle on its bracket, by so little that the wrist stays bent.
inline Frame spindleMount() { return geometry::makeFrame({0.02, 0.0, 0.2}, {0.0, 0.1, 0.0}); }

/// The seed's contact to tool frame: the half turn about x.
inline Frame halfTurn() { return geometry::makeFrame(Vector3::Zero(), {M_PI, 0.0, 0.0}); }

struct Raster {
  Vector3 corner = {0.8, -0.08, 0.4};  ///< lowest x and y [m]
  double width = 0.24, height = 0.16;  ///< along x and y [m]
  double wave = 0.008;                 ///< amplitude of the surface, one period over the width [m]
  int rows = 5, points = 61;
  double feed = 0.05;  ///< [m/s]
  bool zig_zag = true;
};

/// Contact frame on z = wave sin(2 pi x / width), going along +-x.
inline Frame rasterContact(const Raster& raster, double x, double y, double sense) {
  const double k = 2.0 * M_PI / raster.width;
  const Vector3 normal = Vector3(-raster.wave * k * std::cos(k * x), 0.0, 1.0).normalized();
  const Vector3 point = raster.corner + Vector3(x, y, raster.wave * std::sin(k * x));
  return geometry::frameFromAxes(point, normal, sense * Vector3::UnitX());
}

/// Rows in front of the robot, each with an approach and a retract 20 mm above its ends.
inline toolpath::ToolPath rasterPath(const Raster& raster = {}) {
  toolpath::ToolPath path;
  path.process = "cutting";
  path.frame = "base_link";
  path.T_contact_tcp = halfTurn();
  for (int row = 0; row < raster.rows; ++row) {
    const double sense = raster.zig_zag && row % 2 == 1 ? -1.0 : 1.0;
    toolpath::Segment segment;
    segment.name = "row_" + std::to_string(row);
    for (int i = 0; i < raster.points; ++i) {
      const double u = static_cast<double>(i) / (raster.points - 1);
      const double x = raster.width * (sense > 0.0 ? u : 1.0 - u);
      const double y = raster.rows > 1 ? raster.height * row / (raster.rows - 1) : 0.0;
      segment.waypoints.push_back({rasterContact(raster, x, y, sense), raster.feed, true, 0.0});
    }
    toolpath::Waypoint above = segment.waypoints.front(), after = segment.waypoints.back();
    above.pose.translation().z() += 0.02;
    above.process_on = false;
    after.pose.translation().z() += 0.02;
    after.process_on = false;
    segment.waypoints.insert(segment.waypoints.begin(), above);
    segment.waypoints.push_back(after);
    path.segments.push_back(segment);
  }
  return path;
}

/// The same path moved rigidly.
inline toolpath::ToolPath moved(toolpath::ToolPath path, const Frame& T) {
  for (auto& segment : path.segments) {
    for (auto& waypoint : segment.waypoints) waypoint.pose = T * waypoint.pose;
  }
  return path;
}

}  // namespace scan_to_path::motion::test
