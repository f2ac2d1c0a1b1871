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
    visit(self.parameterization, Field{"parameterization", "", "scan_coordinate: x of the scan frame; chord_length; centripetal (the seed's)"});
    visit(self.corner_angle, Field{"corner_angle", "rad", "a sharper bend splits the line", 0.01, 3.2});
    visit(self.corner_window, Field{"corner_window", "m", "length on each side over which a corner's slopes are taken", 1e-5, 0.1});
    visit(self.control_points, Field{"control_points", "", "how many control points a line gets"});
  }
};

/// A corner between samples `index` - 1 and `index` of a piece.
struct Corner {
  std::size_t index = 0;
  double angle = 0.0;  ///< change of direction [rad]
};

/// Bends sharper than corner_angle that do not get milder over half of the window, as a round would: the directions
/// are those of least-squares lines on both sides. Towards the piece's ends the windows are cut short, down to three
/// samples, and the bend must be six times what the samples' noise makes of it. O(samples).
std::vector<Corner> findCorners(const RowPiece& piece, const LineFitOptions& options);

struct FittedLines {
  std::vector<FittedLine> lines;  ///< in the cloud's frame, sorted by row, then along x
  std::vector<Dropped> dropped;   ///< "too short to fit"
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
