// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "track.h"

namespace scan_to_path::scan {

/// A stretch's samples at least a window apart; its last sample closes the list.
using Anchors = std::vector<std::size_t>;

Anchors findAnchors(const Track& track, const Stretch& stretch, double window);

/// The direction (unit) along which most anchors follow each other, one way or the other: that of the rows. Throws
/// InputError when there is none.
Vector2 rowDirection(const Track& track, const std::vector<Anchors>& all);

}  // namespace scan_to_path::scan
