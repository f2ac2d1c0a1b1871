// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::verification {

using geometry::Frame;
using toolpath::WaypointIndex;

/// How far a path's contacts are off a reference surface.
struct PathDeviation {
  std::size_t contacts = 0;  ///< waypoints looked at: those with a worked move to or from them
  double mean = 0.0;         ///< signed distance, positive outside [m]
  double rms = 0.0;          ///< [m]
  double largest = 0.0;      ///< magnitude [m]
  WaypointIndex largest_at;
  double normal_mean = 0.0;     ///< angle between the contact's z and the surface normal [rad]
  double normal_rms = 0.0;      ///< [rad]
  double normal_largest = 0.0;  ///< [rad]
  WaypointIndex normal_largest_at;
};

/// Compares every contact with the reference's closest point. `T_reference_path` maps the path's frame into the
/// reference's. Beyond the border of an open surface the distance is that to the border.
/// Throws InputError when the path has no contact.
PathDeviation measureDeviation(const toolpath::ToolPath& path, const geometry::Surface& reference,
                               const Frame& T_reference_path = Frame::Identity());

}  // namespace scan_to_path::verification
