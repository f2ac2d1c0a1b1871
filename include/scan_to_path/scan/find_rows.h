// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/common/options.h"
#include "scan_to_path/scan/sample_rows.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path::scan {

/// How scan rows are told from the order of the samples.
struct RowOptions {
  double window = 0.00075;
  double max_time_gap = 1.0;
  double min_length = 0.002;
  int min_samples = 8;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.window,
          Field{"window", "m", "distance over which the travel direction is taken; at least three samples", 1e-5, 0.1});
    visit(self.max_time_gap, Field{"max_time_gap", "s", "a longer silence starts a new row", 0.0, 1e6});
    visit(self.min_length, Field{"min_length", "m", "shorter runs are turns, not rows", 0.0, 10.0});
    visit(self.min_samples, Field{"min_samples", "", "runs of fewer samples are turns, not rows", 4, 1e6});
  }
};

/// Finds the scan frame and the raster rows of a cloud whose points are in the order in which they were measured
/// (spec cutting, step 5). The rows' direction is the dominant travel direction across `mean_beam` (the viewing
/// direction in the cloud's frame, any length); samples that travel more than 45 degrees off it lie on turns. A
/// reversal, a silence or a jump starts a new row; runs side by side along x at the same y share a row. Lines given
/// in the cloud's `line` field are taken as they are. Drops "not finite", "no line", "turn".
/// Throws InputError when there are no two rows, no dominant direction, or rows cross each other.
SampleRows findRows(const ScanCloud& cloud, const Vector3& mean_beam, const RowOptions& options);

}  // namespace scan_to_path::scan
