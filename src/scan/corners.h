// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/scan/line_fit.h"

namespace scan_to_path::scan {

/// A corner between samples `index` - 1 and `index` of a piece.
struct Corner {
  std::size_t index = 0;
  double angle = 0.0;  ///< change of direction [rad]
};

/// Bends sharper than corner_angle that do not get milder over half of the window, as a round would: the directions
/// are those of least-squares lines on both sides. Towards the piece's ends the windows are cut short, down to three
/// samples, and the bend must be six times what the samples' noise makes of it. O(samples).
std::vector<Corner> findCorners(const RowPiece& piece, const LineFitOptions& options);

}  // namespace scan_to_path::scan
