// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/common/progress.h"
#include "scan_to_path/nurbs/surface.h"

namespace scan_to_path::nurbs {

/// View of a scan line's samples, `count` of each: heights w over the (u, v) plane [m].
struct HeightSamples {
  const double* u = nullptr;
  const double* v = nullptr;
  const double* w = nullptr;
  std::size_t count = 0;
  int row = -1;  ///< consecutive entries of one row are pieces of one scan line; negative: a line of its own
};

struct SurfaceFitOptions {
  double noise = 0.0;
  int max_control_points = 256;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.noise, Field{"noise", "m", "known sensor noise, standard deviation; 0: by cross-validation", 0, 1});
    visit(self.max_control_points, Field{"max_control_points", "", "upper limit along each direction", 4, 256});
  }
};

/// A fitted height surface with the evidence for it.
struct SurfaceFit {
  Surface surface;          ///< bicubic, points (u, v, w): control points at (Greville u, Greville v, w)
  int count_u = 0;          ///< control points along u
  int count_v = 0;          ///< control points along v
  std::size_t samples = 0;  ///< samples fitted
  double parameters = 0.0;  ///< control points with a sample in their support
  double rms = 0.0;         ///< sqrt(RSS / n) [m]
  double sigma = 0.0;       ///< noise estimate sqrt(RSS / (n - parameters)) [m]
};

/// Least-squares bicubic height function on nearly uniform knots over the samples' bounding rectangle, its numbers of
/// control points along u and v chosen by generalised cross-validation (or Mallows' criterion with known noise).
///
/// `lines` are the scan lines, roughly along u; their number limits the control points along v (two for every three
/// lines). The search goes past 64 control points along a direction only when the best fit has that many: it then
/// counts on a finer grid in steps of a half, and stops before a solution takes above 2e9 multiplications (256 x 84
/// control points take 1.4e9) or when a step improves the criterion by less than a tenth.
/// Cells without samples are bridged by the least thin-plate energy, weighted at the scale of a knot span by 1e-10 of
/// the data: where there are samples even a patch's highest polynomials shrink by no more than 1e-5. On the finer grid
/// it is 1e-5, for knots as close as the rows leave patches at ragged edges nearly bare.
/// Cost: one pass over the samples; after it everything works on sums per grid cell. RMS below about 1e-8 of the
/// height range is rounding.
/// Throws InputError when there are no samples, one is not finite, or they span no rectangle; Interrupted.
SurfaceFit fitHeightSurface(const std::vector<HeightSamples>& lines, const SurfaceFitOptions& options = {},
                            const Progress& progress = {});

/// The same with given numbers of control points, each at least 4. Throws InputError for numbers out of
/// [4, 259] too; with more than the samples determine the thin-plate energy decides.
SurfaceFit fitHeightSurface(const std::vector<HeightSamples>& lines, int count_u, int count_v);

}  // namespace scan_to_path::nurbs
