// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "scan_to_path/common/random.h"
#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::test {

using Profile = std::function<double(double)>;

/// `count` equal rows along x from 0 to 0.1 m, 4 mm apart.
inline scan::SampleRows rowsOf(const Profile& z, double noise = 0.0, int count = 5, double spacing = 50e-6) {
  Random random(7);
  scan::SampleRows rows;
  rows.pitch = 0.004;
  rows.spacing = spacing;
  for (int row = 0; row < count; ++row) {
    scan::RowPiece piece;
    piece.row = row;
    piece.forward = row % 2 == 0;
    for (double x = 0.0; x < 0.1; x += spacing) {
      piece.x.push_back(x);
      piece.y.push_back(0.004 * row);
      piece.z.push_back(z(x) + noise * random.gaussian());
      piece.index.push_back(0);
    }
    rows.pieces.push_back(piece);
  }
  return rows;
}

inline double shortWave(double x) { return 0.01 * std::sin(60.0 * x); }
inline double roof(double x) { return x < 0.04 ? x : 0.08 - x; }

/// Level, then falling at 45 degrees over the last `length`.
inline Profile chamferedEnd(double length) {
  return [length](double x) { return std::min(0.0, 0.1 - length - x); };
}

/// The same rows seen from the other end.
inline scan::SampleRows mirrored(scan::SampleRows rows) {
  for (scan::RowPiece& piece : rows.pieces) {
    for (double& x : piece.x) x = 0.1 - x;
    for (auto* values : {&piece.x, &piece.y, &piece.z}) std::reverse(values->begin(), values->end());
  }
  return rows;
}

}  // namespace scan_to_path::test
