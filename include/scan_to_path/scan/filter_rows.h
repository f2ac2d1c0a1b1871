// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/common/options.h"
#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::scan {

/// What is taken for a depth jump, a spike and a gap.
struct FilterOptions {
  double jump_height = 0.0005;
  double jump_angle = 1.3963;
  int min_run = 5;
  double spike_threshold = 6.0;
  double spike_floor = 0.00003;
  double max_gap = 0.002;
  double min_length = 0.002;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.jump_height,
          Field{"jump_height", "m", "a larger change of height from sample to sample may be a depth jump", 1e-6, 1.0});
    visit(self.jump_angle, Field{"jump_angle", "rad", "a depth jump is steeper than this", 0.1, 1.57});
    visit(self.min_run, Field{"min_run", "", "fewer samples between depth jumps are spikes or edge mixtures", 1, 1000});
    visit(self.spike_threshold, Field{"spike_threshold", "sigma", "residual that makes a sample a spike", 1.0, 100.0});
    visit(self.spike_floor, Field{"spike_floor", "m", "smaller residuals are never spikes", 0.0, 1.0});
    visit(self.max_gap, Field{"max_gap", "m",
                              "a longer gap between samples, in space, cuts the row; at least five samples", 0.0, 1.0});
    visit(self.min_length, Field{"min_length", "m", "shorter pieces are dropped", 0.0, 10.0});
  }
};

/// Cuts rows at depth jumps and gaps and drops spikes (spec cutting, step 6):
/// - a change of height over jump_height and steeper than jump_angle from one sample to the next starts a new run;
///   runs of fewer than min_run samples are dropped, and what then fits together again is one piece;
/// - Hampel's rule on the residual from the median of the midpoints of symmetric neighbour pairs, which is blind to
///   slope; at ends and where it fires, on those from linear extrapolation, which are blind to corners. The scale is
///   1.4826 times the median absolute residual, pooled over all rows.
/// Heights are not changed. Drops "spike", "spike or edge", "short piece". Same bytes for any number of threads.
SampleRows filterRows(SampleRows rows, const FilterOptions& options, int threads = 1);

}  // namespace scan_to_path::scan
