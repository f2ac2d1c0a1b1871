// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::verification {

using geometry::Frame;
using geometry::SurfacePoint;
using geometry::Vector3;

/// A square grid of rays looking along -z of a frame, for sampling a surface.
struct SampleGrid {
  Frame T_surface_grid = Frame::Identity();  ///< rays start in its x-y plane
  double x_min = 0.0;                        ///< [m], in the grid's frame as all ranges
  double x_max = 0.0;
  double y_min = 0.0;
  double y_max = 0.0;
  double spacing_x = 5e-4;  ///< [m]
  double spacing_y = 5e-4;  ///< [m]; a cusp between rows falls by L / (2 r) of what a ray misses it by
};

/// Where the grid's rays hit the surface; rays that miss are left out. In the surface's frame.
/// Throws InputError for a spacing that is not positive or an empty range.
std::vector<SurfacePoint> sampleSurface(const geometry::Surface& surface, const SampleGrid& grid);

/// The material that a ball end mill leaves on a surface, measured along the surface's normals.
struct ScallopReport {
  std::size_t points = 0;  ///< surface points looked at
  std::size_t uncut = 0;   ///< of them with more left than the limit: no ball came near
  double highest = 0.0;    ///< of the others [m]
  Vector3 highest_at = Vector3::Zero();
  double mean = 0.0;           ///< [m]
  double median = 0.0;         ///< [m]
  double percentile_95 = 0.0;  ///< [m]
  double deepest_cut = 0.0;    ///< of the ball below the surface [m], 0 when it never is
  Vector3 deepest_at = Vector3::Zero();
  std::vector<double> heights;  ///< one per point, negative below the surface; NaN where uncut
};

/// Sweeps the ball along every worked move, straight from contact to contact with its centre at p + r z of the contact
/// frames (so each move cuts a capsule), and looks along each point's normal for the first capsule: what lies below it
/// is left. `points` are in the path's frame; only heights up to `limit` [m] are searched for.
/// Shares no code with the planner. Same result for any number of threads. O(points * log moves).
/// Throws InputError for a radius or limit that is not positive or a path without a worked move.
ScallopReport checkScallops(const toolpath::ToolPath& path, double ball_radius, const std::vector<SurfacePoint>& points,
                            double limit, int threads = 1);

}  // namespace scan_to_path::verification
