// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/common/options.h"
#include "scan_to_path/common/progress.h"
#include "scan_to_path/nurbs/surface_fit.h"
#include "scan_to_path/scan/background.h"
#include "scan_to_path/scan/filter_rows.h"
#include "scan_to_path/scan/find_rows.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/scan/line_fit.h"
#include "scan_to_path/scan/normals.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path::scan {

/// From the raw cloud to clean rows.
struct ScanOptions {
  RowOptions rows;
  FilterOptions filter;
  BackgroundOptions background;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.rows, Field{"rows", "", "how scan rows are told apart"});
    visit(self.filter, Field{"filter", "", "depth jumps, spikes and gaps"});
    visit(self.background, Field{"background", "", "the table behind the part"});
  }
};

/// From clean rows to curves, surface and normals.
struct FitOptions {
  LineFitOptions lines;
  bool with_surface = true;
  nurbs::SurfaceFitOptions surface;
  NormalMode normals = NormalMode::weighted;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.lines, Field{"lines", "", "how rows become curves"});
    visit(self.with_surface, Field{"with_surface", "", "fit a surface through all rows as well"});
    visit(self.surface, Field{"surface", "", "how many control points the surface gets"});
    visit(self.normals, Field{"normals", "",
                              "weighted: differences across the rows, second order; seed: its four triangles; surface: "
                              "of the fitted surface"});
  }
};

/// Rows of the part alone: findRows, filterRows, removeBackground.
SampleRows cleanRows(const ScanCloud& cloud, const Vector3& mean_beam, const ScanOptions& options, int threads = 1,
                     const Progress& progress = {});

/// Lines, surface and outline of clean rows.
FittedScan fitRows(const SampleRows& rows, const FitOptions& options, int threads = 1, const Progress& progress = {});

/// fitRows(cleanRows(…)): everything from a cloud in measured order (spec cutting, steps 5-8). `mean_beam` is the
/// viewing direction in the cloud's frame. Normals follow with orientLines. Same bytes for any number of threads.
/// Throws InputError when the cloud is no raster scan of a part, Interrupted when asked to stop.
FittedScan fitScan(const ScanCloud& cloud, const Vector3& mean_beam, const ScanOptions& scan_options,
                   const FitOptions& fit_options, int threads = 1, const Progress& progress = {});

}  // namespace scan_to_path::scan
