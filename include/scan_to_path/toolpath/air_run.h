// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::toolpath {

using geometry::Vector3;

/// The path `lift` [m, in the path's frame] off the part with the process off on every move: what an air run drives.
/// Feeds and names stay. Applied twice equals once: a path that is lifted already is only moved by the difference.
/// Throws InputError for a lift that is not finite or that takes the tool less than half its length off the surface,
/// along the normal of some waypoint of the process.
ToolPath lifted(ToolPath path, const Vector3& lift);

}  // namespace scan_to_path::toolpath
