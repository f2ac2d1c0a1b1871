// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scan_to_path/geometry/frames.h"
#include "scan_to_path/nurbs/curve.h"
#include "scan_to_path/nurbs/surface.h"
#include "scan_to_path/scan/obstacles.h"

namespace scan_to_path::scan {

using geometry::Frame;
using geometry::Vector3;

/// How many samples were left out, and why.
struct Dropped {
  std::string reason;
  std::size_t count = 0;
};

/// A stretch of one scan row without gap, jump or corner, fitted by a cubic B-spline in the cloud's frame.
struct FittedLine {
  int row = 0;                 ///< raster row, 0 … in the order across; the stretches of one row share it
  bool forward = true;         ///< scanned towards +x of the scan frame
  nurbs::Curve curve;          ///< runs towards +x of the scan frame whatever the scan direction was
  double begin = 0.0;          ///< curve parameter of the part's boundary, or of the cut, at the line's start
  double end = 0.0;            ///< … and at its end
  bool begins_at_edge = true;  ///< false where the line was cut at a corner or gap inside the part
  bool ends_at_edge = true;
  std::size_t samples = 0;
  double residual_rms = 0.0;  ///< of the samples normal to the line's mean plane, that is, along the beam [m]
  double sigma = 0.0;         ///< estimated noise along the beam [m]
};

/// A point of a fitted line with what a contact frame needs.
struct OrientedPoint {
  Vector3 point = Vector3::Zero();     ///< [m]
  Vector3 normal = Vector3::UnitZ();   ///< unit, on the sensor's side
  Vector3 tangent = Vector3::UnitX();  ///< unit, towards +x of the scan frame
  double parameter = 0.0;              ///< of the fitted line
};

/// The oriented points of fitted line number `line`.
struct OrientedLine {
  int line = 0;
  std::vector<OrientedPoint> points;
};

/// The part's extent: closed polygons in the x-y plane of the scan frame, outer ones counter-clockwise, holes
/// clockwise.
struct Outline {
  std::vector<std::vector<Eigen::Vector2d>> polygons;  ///< [m]
};

/// What a scan became: lines, the surface through them, the outline, and what was dropped on the way.
struct FittedScan {
  /// Scan frame in the cloud's frame: z against the mean beam (towards the sensor), x along the rows, y across.
  Frame T_cloud_scan = Frame::Identity();
  std::vector<FittedLine> lines;  ///< sorted by row, then along x
  /// Height over the scan plane: x = u, y = v, z = height, u and v in metres of the scan frame.
  nurbs::Surface surface;
  Outline outline;
  Obstacles obstacles;  ///< beside the part and on it, thinned to obstacle_spacing
  std::size_t samples_in = 0;
  std::size_t samples_used = 0;
  std::vector<Dropped> dropped;
  double pitch = 0.0;                 ///< median distance of neighbouring rows [m]
  double line_sigma = 0.0;            ///< pooled noise estimate of the lines along the beam [m]
  double surface_rms = 0.0;           ///< of the samples off the surface along the beam [m]
  double between_rows_rms = 0.0;      ///< what the rows leave unknown between them: see BetweenRows [m]
  double between_rows_largest = 0.0;  ///< [m]
  double between_rows_share = 0.0;    ///< of the rows' length that both cover
};

}  // namespace scan_to_path::scan
