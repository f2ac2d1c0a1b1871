// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/nurbs/control_point_choice.h"
#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::scan {

enum class Parameterization { scan_coordinate, chord_length, centripetal };

/// How rows become curves.
struct LineFitOptions {
  Parameterization parameterization = Parameterization::scan_coordinate;
  double corner_angle = 0.35;
  double corner_window = 0.001;
  nurbs::CurveFitOptions control_points;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.parameterization, Field{"parameterization", "",
                                       "scan_coordinate: x of the scan frame; chord_length; centripetal (the seed's)"});
    visit(self.corner_angle, Field{"corner_angle", "rad", "a sharper bend splits the line", 0.01, 3.2});
    visit(self.corner_window,
          Field{"corner_window", "m", "length on each side over which a corner's slopes are taken", 1e-5, 0.1});
    visit(self.control_points, Field{"control_points", "", "how many control points a line gets"});
  }
};

struct FittedLines {
  std::vector<FittedLine> lines;  ///< in the cloud's frame, sorted by row, then along x
  std::vector<Dropped> dropped;   ///< "too short to fit"
  Obstacles too_short;            ///< their samples, in the scan frame
};

/// Least-squares cubic B-spline of every piece (eqs. 3-7; spec cutting, step 7) through all its samples, split at
/// corners and at gaps longer than a knot span. Runs on up to `threads` threads, same bytes for any number.
/// Throws InputError when no piece can be fitted.
FittedLines fitLines(const SampleRows& rows, const LineFitOptions& options, int threads = 1);

}  // namespace scan_to_path::scan

namespace scan_to_path {
template <>
struct EnumNames<scan::Parameterization> {
  static constexpr std::array<const char*, 3> names = {"scan_coordinate", "chord_length", "centripetal"};
};
}  // namespace scan_to_path
