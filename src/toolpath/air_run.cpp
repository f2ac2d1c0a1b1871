// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/air_run.h"

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/toolpath/contact_frame.h"

namespace scan_to_path::toolpath {
namespace {

/// Half the length along the normal: 60 degrees between the normal and the lift.
constexpr double least_share = 0.5;

void checkLift(const ToolPath& path, const Vector3& lift) {
  if (!lift.allFinite()) throw InputError("air run: the lift is not finite");
  for (const auto& segment : path.segments) {
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      const double off = lift.dot(segment.waypoints[i].pose.linear().col(2));
      if (!isContact(segment, i) || off >= least_share * lift.norm()) continue;
      throw InputError("segment " + segment.name + " waypoint " + std::to_string(i),
                       "lift of the air run along the normal", fixed(1e3 * off, 3) + " mm",
                       "at least half of dry_offset: turn program.dry_direction towards the outward normals");
    }
  }
}

}  // namespace

ToolPath lifted(ToolPath path, const Vector3& lift) {
  checkLift(path, lift);
  const Vector3 by = lift - path.lift;
  for (auto& segment : path.segments) {
    for (auto& waypoint : segment.waypoints) {
      waypoint.pose.translation() += by;
      waypoint.process_on = false;
    }
  }
  path.lift = lift;
  return path;
}

}  // namespace scan_to_path::toolpath
