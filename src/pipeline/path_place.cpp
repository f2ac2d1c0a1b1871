// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/path_place.h"

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

std::string rangesText(const Eigen::AlignedBox3d& box) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    text += std::string(axis > 0 ? ", " : "") + "xyz"[axis] + " " + fixed(box.min()[axis], 3) + " to " +
            fixed(box.max()[axis], 3);
  }
  return text + " m";
}

}  // namespace

PathPlace placeOf(const toolpath::ToolPath& path, const geometry::Frame& T_base_workobject) {
  PathPlace place;
  place.frame = path.frame;
  const geometry::Frame T_workobject_base = T_base_workobject.inverse();
  for (const auto& segment : path.segments) {
    const auto& waypoints = segment.waypoints;
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
      // The process is on for a move: from the waypoint before to this one.
      if (!waypoints[i].process_on && (i + 1 == waypoints.size() || !waypoints[i + 1].process_on)) continue;
      place.in_frame.extend(waypoints[i].pose.translation());
      place.in_work_object.extend(T_workobject_base * waypoints[i].pose.translation());
    }
  }
  return place;
}

std::string placeText(const PathPlace& place) {
  if (place.isEmpty()) return "";
  return rangesText(place.in_frame) + " in " + place.frame + ", " + rangesText(place.in_work_object) +
         " in the work object";
}

}  // namespace scan_to_path::pipeline
