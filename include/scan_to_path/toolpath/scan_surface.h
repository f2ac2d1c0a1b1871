// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/geometry/height_jet.h"
#include "scan_to_path/nurbs/height_surface.h"

namespace scan_to_path::toolpath {

using geometry::HeightJet;
using geometry::Vector3;

/// The height surface of a fitted scan, in the scan frame: z = f(x, y) with its outward normal on the sensor's side.
class ScanSurface {
public:
  /// Throws InputError unless the surface is a bicubic height over the scan plane, x = u and y = v.
  explicit ScanSurface(const nurbs::Surface& surface) : surface_(surface) {}

  /// Height and derivatives at (x, y) [m]. Outside the domain the border's polynomial goes on.
  HeightJet jet(double x, double y) const;

  /// The height alone [m].
  double height(double x, double y) const { return surface_.height(x, y); }

private:
  nurbs::HeightSurface surface_;
};

/// Unit normal of the graph, z component positive.
Vector3 normalOf(const HeightJet& jet);

/// Signed normal curvature [1/m], convex positive, in the tangent direction that lies over the plan direction.
double normalCurvature(const HeightJet& jet, const Eigen::Vector2d& plan_direction);

/// Smallest signed principal curvature [1/m], convex positive: the most hollow direction.
double smallestCurvature(const HeightJet& jet);

}  // namespace scan_to_path::toolpath
