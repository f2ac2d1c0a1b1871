// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/scan/find_rows.h"
#include "travel_direction.h"

namespace scan_to_path::scan {

/// Samples [begin, end) that travel one way along the rows.
struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool forward = true;
  double low = 0.0;  ///< range along x
  double high = 0.0;
  double y = 0.0;  ///< mean
  int row = -1;
};

/// Samples [begin, end) of a track whose x is along the rows; not empty.
Run makeRun(const Track& track, std::size_t begin, std::size_t end, bool forward);

/// What of each stretch travels along the rows, without the turns; a stretch as a whole when lines are given. In
/// measured order, each sample in one run at most.
std::vector<Run> findRuns(const Track& track, const std::vector<Anchors>& all, bool lines_given);

/// Drops runs of fewer than min_samples or shorter than min_length. Throws InputError when not even the longest one
/// has min_samples.
void keepLongRuns(std::vector<Run>& runs, const RowOptions& options);

}  // namespace scan_to_path::scan
