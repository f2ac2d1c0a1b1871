// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::toolpath {

using geometry::Vector3;

/// Contact frame (seed 000 eq. 11, put right-handed): origin at `point`, z = v_n the outward normal, x = v_t the feed
/// direction made orthogonal to it, y = v_e = v_n x v_t. `normal` and `feed_direction` may have any length.
/// Throws InputError when one of them is zero or not finite, or when they are parallel.
Frame contactFrame(const Vector3& point, const Vector3& normal, const Vector3& feed_direction);

/// True where the tool touches the part at waypoint `index`: the move to it or the one away from it is worked.
bool isContact(const Segment& segment, std::size_t index);

/// True for a segment that works, not an approach, a link or a retract.
bool isRow(const Segment& segment);

}  // namespace scan_to_path::toolpath
