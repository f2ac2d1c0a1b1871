// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/scan_surface.h"

#include <algorithm>
#include <cmath>

namespace scan_to_path::toolpath {

HeightJet ScanSurface::jet(double x, double y) const {
  const nurbs::HeightDerivatives height = surface_.at(x, y);
  return {height.w, height.u, height.v, height.uu, height.uv, height.vv};
}

Vector3 normalOf(const HeightJet& jet) { return Vector3(-jet.zx, -jet.zy, 1.0).normalized(); }

double normalCurvature(const HeightJet& jet, const Eigen::Vector2d& d) {
  const double rise = jet.zx * d.x() + jet.zy * d.y();
  const double second = jet.zxx * d.x() * d.x() + 2.0 * jet.zxy * d.x() * d.y() + jet.zyy * d.y() * d.y();
  const double w = std::sqrt(1.0 + jet.zx * jet.zx + jet.zy * jet.zy);
  return -second / (w * (d.squaredNorm() + rise * rise));
}

double smallestCurvature(const HeightJet& jet) {
  const double w2 = 1.0 + jet.zx * jet.zx + jet.zy * jet.zy;
  const double mean =
      -((1.0 + jet.zy * jet.zy) * jet.zxx - 2.0 * jet.zx * jet.zy * jet.zxy + (1.0 + jet.zx * jet.zx) * jet.zyy) /
      (2.0 * w2 * std::sqrt(w2));
  const double gauss = (jet.zxx * jet.zyy - jet.zxy * jet.zxy) / (w2 * w2);
  return mean - std::sqrt(std::max(0.0, mean * mean - gauss));
}

}  // namespace scan_to_path::toolpath
