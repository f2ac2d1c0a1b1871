// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "runs.h"

namespace scan_to_path::scan {

/// One piece per row and travel direction, sorted by row, its samples relative to `origin` and ordered by x; what
/// interrupts it is decided later, by the gap's length. Sorts the runs.
std::vector<RowPiece> makePieces(const Track& track, std::vector<Run>& runs, const Vector3& origin);

}  // namespace scan_to_path::scan
