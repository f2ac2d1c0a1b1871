// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "scan_to_path/process/planner.h"
#include "support/fitted_scans.h"

namespace scan_to_path::test {

/// 100 mm by 60 mm, [m].
inline const geometry::Rectangle flat_area = {0.0, 0.1, 0.0, 0.06};

/// A scan of a plane at z = 10 mm in sixteen lines 4 mm apart.
inline scan::FittedScan flatPlate(const geometry::Frame& T = geometry::Frame::Identity()) {
  return fittedScan([](double, double) { return 0.01; }, flat_area, 0.004, 8, 8, T);
}

/// A figure of a plan by its name; null when it has none.
inline const process::Figure* figureOf(const process::PlannedPath& plan, const std::string& name) {
  const auto found =
      std::find_if(plan.figures.begin(), plan.figures.end(), [&](const auto& f) { return f.name == name; });
  return found == plan.figures.end() ? nullptr : &*found;
}

}  // namespace scan_to_path::test
