// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scan_to_path/common/options.h"
#include "scan_to_path/common/progress.h"
#include "scan_to_path/sensing/place_samples.h"

namespace scan_to_path::sensing {

/// How the offset between the clocks is estimated.
struct ClockOffsetOptions {
  double cell = 0.002;
  double min_slope = 0.01;
  int max_rows = 60;
  double max_standard_error = 2e-5;
  double largest_offset = 0.01;
  double max_effect = 2e-5;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.cell, Field{"cell", "m", "spacing along a row at which rows are compared", 1e-5, 0.1});
    visit(self.min_slope, Field{"min_slope", "", "slope along a row from which a place tells something", 1e-6, 1.0});
    visit(self.max_rows, Field{"max_rows", "", "rows looked at, spread over the scan", 8, 100000});
    visit(self.max_standard_error,
          Field{"max_standard_error", "s", "above it the offset counts as not observable", 1e-9, 1.0});
    visit(self.largest_offset,
          Field{"largest_offset", "s", "that may be where the scan does not tell and none is stated", 1e-6, 1.0});
    visit(self.max_effect,
          Field{"max_effect", "m", "a part that largest_offset moves by less in height is flat: none is needed", 0.0,
                1.0});
  }
};

/// What a scan tells of the offset.
enum class Observability {
  observable,
  uncertain,   ///< there is an estimate, its standard error above the largest that was asked for
  few_slopes,  ///< too few places to compare rows at: offsetEffect tells whether an offset would matter there
  none,        ///< rows in one direction, too few of them, or rows that do not come to agree
};

/// The offset and how well it is known.
struct ClockOffsetEstimate {
  Observability observability = Observability::none;
  std::string reason;           ///< why it is not observable, in words; empty when it is
  double offset = 0.0;          ///< that makes rows agree; where the search started when there is no estimate [s]
  double standard_error = 0.0;  ///< from the scatter between groups of rows [s]
  int rows = 0;                 ///< looked at
  int cells = 0;                ///< places used
  int iterations = 0;
};

/// Estimates the offset between the sensor's and the encoders' clocks from rows scanned forward and backward: an
/// offset error of dt shifts them against each other by 2 v dt (spec cutting, step 3). Across four neighbouring rows
/// the third divided difference of the height is free of the part's shape to second order, and changes with dt by
/// the sum of the rows' v times slope: that is solved for dt by robust least squares (Tukey's biweight), and repeated
/// with samples placed anew until dt is below 1 us. Nothing but the log goes in. `placement.clock_offset` is where the
/// search starts. Rows in one direction only, too few slopes, or too few rows are told as data, not as errors.
/// Throws what placeSamples throws for a log that does not fit the robot. About 30 ms, and 10 ms more for
/// every million samples.
ClockOffsetEstimate estimateClockOffset(const scan::SampleLog& log, const robot::Robot& robot,
                                        const robot::Encoders& encoders, const PointLaserOptions& laser,
                                        const Frame& T_tip_sensor, const PlacementOptions& placement = {},
                                        const ClockOffsetOptions& options = {}, const Progress& progress = {});

}  // namespace scan_to_path::sensing
