// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/path_deviation.h"

#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/toolpath/contact_frame.h"

namespace scan_to_path::verification {
namespace {

using geometry::Vector3;

void add(PathDeviation& deviation, double distance, double angle, const WaypointIndex& at) {
  ++deviation.contacts;
  deviation.mean += distance;
  deviation.rms += distance * distance;
  deviation.normal_mean += angle;
  deviation.normal_rms += angle * angle;
  if (std::abs(distance) > deviation.largest) {
    deviation.largest = std::abs(distance);
    deviation.largest_at = at;
  }
  if (angle > deviation.normal_largest) {
    deviation.normal_largest = angle;
    deviation.normal_largest_at = at;
  }
}

/// Sums become means.
void finish(PathDeviation& deviation) {
  const double count = static_cast<double>(deviation.contacts);
  deviation.mean /= count;
  deviation.rms = std::sqrt(deviation.rms / count);
  deviation.normal_mean /= count;
  deviation.normal_rms = std::sqrt(deviation.normal_rms / count);
}

}  // namespace

PathDeviation measureDeviation(const toolpath::ToolPath& path, const geometry::Surface& reference,
                               const Frame& T_reference_path) {
  PathDeviation deviation;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const auto& segment = path.segments[s];
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      if (!toolpath::isContact(segment, i)) continue;
      const Frame pose = T_reference_path * segment.waypoints[i].pose;
      const geometry::SurfacePoint nearest = reference.closestPoint(pose.translation());
      const Vector3 off = pose.translation() - nearest.point;
      const double distance = std::copysign(off.norm(), off.dot(nearest.normal));
      const double angle = geometry::angleBetween(pose.linear().col(2), nearest.normal);
      add(deviation, distance, angle, {static_cast<int>(s), static_cast<int>(i)});
    }
  }
  if (deviation.contacts == 0) throw InputError("path deviation: no move of the path works");
  finish(deviation);
  return deviation;
}

}  // namespace scan_to_path::verification
