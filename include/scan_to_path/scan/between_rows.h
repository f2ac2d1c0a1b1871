// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::scan {

/// Estimate of how far any surface through the rows lies off the part half way between them, along its normal [m].
struct BetweenRows {
  double rms = 0.0;
  double largest = 0.0;
  std::size_t points = 0;  ///< compared; 0: fewer than five rows pass anywhere, nothing is known
  double share = 0.0;      ///< of the rows' length that lies in five neighbouring rows at the same x, which this covers
};

/// Each row against the cubic through the two rows on both sides of it at the same x, every quarter of a pitch.
///
/// A cubic through rows at +-h and +-2h misses w'''' h^4 / 6 at 0; half way between rows, from +-h/2 and +-3h/2, it
/// misses 9/64 of that. A feature finer than the rows does not get smaller that way, so the order p with which the
/// error grew from the rows at +-2h and +-4h to those at +-h and +-2h decides: what remains is (9/64)^(p/4) of the
/// error, p within [0, 4]: 0.14 for a smooth part, 0.61 for a crease, all of it for a step. Where the rows for
/// p are missing, a crease is taken. Blind to what falls between the rows everywhere. O(lines' length / pitch).
BetweenRows estimateBetweenRows(const FittedScan& scan);

}  // namespace scan_to_path::scan
