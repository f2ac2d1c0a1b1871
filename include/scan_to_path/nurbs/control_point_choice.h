// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/nurbs/line_moments.h"

namespace scan_to_path::nurbs {

/// How the number of control points is chosen.
struct CurveFitOptions {
  int window = 3;
  double noise = 0.0;
  int max_control_points = 1000;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.window, Field{"window", "lines", "neighbours on each side that choose knot spacing jointly", 0, 1000});
    visit(self.noise, Field{"noise", "m", "known sensor noise, standard deviation; 0: by cross-validation", 0, 1});
    visit(self.max_control_points, Field{"max_control_points", "", "upper limit per line", 4, 100000});
  }
};

/// Number of control points for each line, minimising generalised cross-validation n RSS / (n - p)^2 or, with known
/// noise, RSS + 2 noise^2 p (Mallows), both pooled over the line and its `window` neighbours on each side at the same
/// knot spacing. 4, 5, 6 … are tried, then steps of at most 15 %, as far as any line of the window shows structure.
/// A neighbour that does not allow all of the line's candidates, or is not half to twice as long, is left out of the
/// pool.
/// 0 for a line that allows none. The result does not depend on `threads`.
std::vector<int> chooseControlPoints(const std::vector<LineMoments>& lines, const CurveFitOptions& options,
                                     int threads = 1);

}  // namespace scan_to_path::nurbs
