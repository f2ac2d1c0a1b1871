// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/process/cutting_options.h"
#include "scan_to_path/process/row.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/outline_clip.h"
#include "scan_to_path/toolpath/region.h"
#include "scan_to_path/toolpath/scan_surface.h"

namespace scan_to_path::process {

/// Makes the rows of surfaceRows() at any place across. Keeps a reference to the options.
class RowMaker {
public:
  /// Throws InputError for an outline that bounds nothing, and a surface that is no height over the scan plane.
  RowMaker(const scan::FittedScan& scan, const CuttingOptions& options);

  const toolpath::ScanSurface& surface() const { return surface_; }

  /// The least (sign +1) or largest (sign -1) place across where there is a row.
  double edge(int sign) const;

  std::vector<Row> rowsAt(double s, int number) const;

  /// The pieces of a row in a region; the row itself where it is whole.
  std::vector<Row> inRegion(const Row& row, const toolpath::Region& region) const;

  /// Unit, in the scan plane.
  const Eigen::Vector2d& across() const { return across_; }

  /// How far the next row's plane may be by the exact rule with this row's curvatures and slopes; planeDistance without
  /// a row.
  double ruleDistance(const std::vector<Row>& rows) const;

  /// L of the rule on a plane.
  double planeDistance() const;

private:
  toolpath::HeightJet jetAt(double t, double s) const;

  bool hasRow(double s) const;

  /// Length of the rows at s, seen from above [m].
  double coveredAt(double s) const;

  RowPoint pointAt(double t, double s) const;

  /// Waypoints per metre of t that keep the chord of the contact line and of the ball's centre within the tolerance.
  double density(double t, double s) const;

  /// Points at equal shares of the integrated density; per cell the density is its larger end's.
  std::vector<RowPoint> sampled(const toolpath::Interval& interval, double s) const;

  double ruleDistanceAt(const RowPoint& p) const;

  const CuttingOptions& options_;
  toolpath::ScanSurface surface_;
  toolpath::OutlineClip clip_;
  Eigen::Vector2d along_;
  Eigen::Vector2d across_;
};

}  // namespace scan_to_path::process
