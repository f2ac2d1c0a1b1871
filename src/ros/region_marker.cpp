// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/region_marker.h"

#include <algorithm>
#include <limits>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path_ros {
namespace {

using scan_to_path::geometry::Frame;
using scan_to_path::geometry::Vector3;
using visualization_msgs::Marker;

constexpr double line_width = 1e-3;  // [m]

/// Over the work object's x-y plane; a spline lies below its control points.
double highest(const scan_to_path::scan::FittedScan& scan, const Frame& T_workobject_scan) {
  double z = std::numeric_limits<double>::lowest();
  for (const auto& line : scan.lines) {
    for (const Vector3& point : line.curve.control_points) z = std::max(z, (T_workobject_scan * point).z());
  }
  return scan.lines.empty() ? 0.0 : z;
}

}  // namespace

Marker regionMarker(const scan_to_path::pipeline::JobOptions& options, const scan_to_path::scan::FittedScan& scan,
                    const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.ns = "region";
  marker.type = Marker::LINE_STRIP;
  marker.action = options.path.region.empty() ? Marker::DELETE : Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = line_width;
  marker.color.r = marker.color.b = marker.color.a = 1.0F;
  if (options.path.region.empty()) return marker;
  const Frame T_base_workobject = options.cell.workpiece.frame();
  const double z = highest(scan, T_base_workobject.inverse());
  for (std::size_t i = 0; i <= options.path.region.size(); ++i) {
    const auto& corner = options.path.region[i % options.path.region.size()];
    const Vector3 p = T_base_workobject * Vector3(corner.x(), corner.y(), z);
    geometry_msgs::Point point;
    point.x = p.x();
    point.y = p.y();
    point.z = p.z();
    marker.points.push_back(point);
  }
  return marker;
}

}  // namespace scan_to_path_ros
