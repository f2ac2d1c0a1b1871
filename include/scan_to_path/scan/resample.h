// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::scan {

/// How densely a line is resampled.
struct ResampleOptions {
  double spacing = 0.001;
  double chord_error = 0.0;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.spacing, Field{"spacing", "m", "largest distance of points along the line", 1e-6, 1.0});
    visit(self.chord_error,
          Field{"chord_error", "m", "largest distance of the curve from the chord between points; 0: any", 0.0, 0.1});
  }
};

/// Parameters at which the line is to be sampled, rising, from line.begin to line.end, both included. Without a chord
/// error the points have equal distances along the line, the largest that divides it and is not above spacing; with
/// one they are nearer to each other where the curve bends: step <= sqrt(8 chord_error / curvature).
/// Throws InputError when the line's end is not after its begin.
std::vector<double> resampleParameters(const FittedLine& line, const ResampleOptions& options);

}  // namespace scan_to_path::scan
