// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::toolpath {

using geometry::Vector3;

/// A ball end mill held at a constant attitude to its contact frame.
struct BallTool {
  double radius = 0.0;  ///< of the ball [m]
  /// Turn about the contact frame's y axis [rad]: positive leans the shank towards the feed direction.
  double lead = 0.0;
  /// Turn about the contact frame's x axis, before the lead [rad]: positive leans the shank to the contact frame's -y.
  double tilt = 0.0;
};

/// The tool centre point, which is the ball's pole, in the contact frame. The tool's +z runs along its axis out of the
/// tool into the work. Spec cutting, step 13: c = p + r n and TCP = c + r z_tool, that is
///   T = Trans(0, 0, r) Rot(y, lead) Rot(x, tilt) Trans(0, 0, -r) Rot(x, 180 deg).
/// With lead and tilt 0 the TCP is the contact point.
/// Throws InputError unless the radius is positive and lead and tilt are within +-80 degrees.
Frame ballToolFrame(const BallTool& tool);

/// The ball's centre for a contact frame, c = p + r n.
Vector3 ballCentre(const Frame& contact, double radius);

}  // namespace scan_to_path::toolpath
