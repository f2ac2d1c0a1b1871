// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "../src/scan/runs.h"

namespace scan_to_path::test {

/// Samples at the given x and y, their numbers as index.
inline scan::Track trackOf(const std::vector<std::pair<double, double>>& places) {
  scan::Track track;
  for (const auto& [x, y] : places) {
    track.index.push_back(static_cast<std::uint32_t>(track.x.size()));
    track.x.push_back(x);
    track.y.push_back(y);
    track.z.push_back(0.0);
  }
  return track;
}

/// Goes on from the track's last sample to (x, y) in `steps` equal steps.
inline void goTo(scan::Track& track, double x, double y, int steps) {
  const Eigen::Vector2d from = track.at(track.size() - 1);
  for (int k = 1; k <= steps; ++k) {
    track.index.push_back(static_cast<std::uint32_t>(track.x.size()));
    track.x.push_back(from.x() + (x - from.x()) * k / steps);
    track.y.push_back(from.y() + (y - from.y()) * k / steps);
    track.z.push_back(0.0);
  }
}

/// Rows of ten units along x, one unit apart, in zig-zag and with their turns: 0.1 from sample to sample.
inline scan::Track zigZag(int rows) {
  scan::Track track = trackOf({{0.0, 0.0}});
  for (int row = 0; row < rows; ++row) {
    if (row > 0) goTo(track, track.x.back(), row, 10);
    goTo(track, row % 2 == 0 ? 10.0 : 0.0, row, 100);
  }
  return track;
}

}  // namespace scan_to_path::test
