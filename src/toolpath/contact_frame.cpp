// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/contact_frame.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"

namespace scan_to_path::toolpath {

Frame contactFrame(const Vector3& point, const Vector3& normal, const Vector3& feed_direction) {
  if (!point.allFinite()) throw InputError("contact frame: the point is not finite");
  const double normal_length = normal.norm();
  const double feed_length = feed_direction.norm();
  if (!(normal_length > 0.0) || !std::isfinite(normal_length)) {
    throw InputError("contact frame: the normal has no direction");
  }
  if (!(feed_length > 0.0) || !std::isfinite(feed_length)) {
    throw InputError("contact frame: the feed direction has no direction");
  }
  const Vector3 v_n = normal / normal_length;
  const Vector3 v_t = feed_direction / feed_length;
  if (!(v_n.cross(v_t).norm() > 1e-9)) throw InputError("contact frame: the feed direction is parallel to the normal");
  return geometry::frameFromAxes(point, v_n, v_t);  // Equation (11), v_e = v_n x v_t
}

bool isContact(const Segment& segment, std::size_t index) {
  const auto& waypoints = segment.waypoints;
  return waypoints[index].process_on || (index + 1 < waypoints.size() && waypoints[index + 1].process_on);
}

bool isRow(const Segment& segment) {
  return std::any_of(segment.waypoints.begin(), segment.waypoints.end(),
                     [](const Waypoint& waypoint) { return waypoint.process_on; });
}

}  // namespace scan_to_path::toolpath
