// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/scan_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::toolpath {
namespace {

using Basis = std::array<double, 3 * (nurbs::max_degree + 1)>;

void checkAbscissae(const nurbs::Surface& surface) {
  const auto x = nurbs::grevilleAbscissae(surface.knots_u, surface.degree_u);
  const auto y = nurbs::grevilleAbscissae(surface.knots_v, surface.degree_v);
  const double tolerance = 1e-9;  // [m], far below any path's accuracy
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      const Vector3& p = surface.control_points[i * y.size() + j];
      if (!(std::abs(p.x() - x[i]) <= tolerance && std::abs(p.y() - y[j]) <= tolerance)) {
        throw InputError("scan surface: control point (" + std::to_string(i) + ", " + std::to_string(j) +
                         ") does not make x = u and y = v, the surface is no height over the scan plane");
      }
    }
  }
}

}  // namespace

ScanSurface::ScanSurface(const nurbs::Surface& surface) : surface_(surface) {
  nurbs::validate(surface);
  if (std::any_of(surface.weights.begin(), surface.weights.end(), [](double w) { return w != 1.0; })) {
    throw InputError("scan surface: weights must be 1, the surface is no height over the scan plane");
  }
  checkAbscissae(surface);
}

HeightJet ScanSurface::jet(double x, double y) const {
  const auto& s = surface_;
  const std::size_t pu = static_cast<std::size_t>(s.degree_u);
  const std::size_t pv = static_cast<std::size_t>(s.degree_v);
  const std::size_t span_u = nurbs::findSpan(s.knots_u, s.degree_u, x);
  const std::size_t span_v = nurbs::findSpan(s.knots_v, s.degree_v, y);
  Basis nu;
  Basis nv;
  nurbs::basisDerivatives(s.knots_u, s.degree_u, span_u, x, 2, nu.data());
  nurbs::basisDerivatives(s.knots_v, s.degree_v, span_v, y, 2, nv.data());
  const double* nv0 = nv.data();
  const double* nv1 = nv0 + pv + 1;
  const double* nv2 = nv1 + pv + 1;
  HeightJet jet;
  for (std::size_t i = 0; i <= pu; ++i) {
    const Vector3* row = &s.control_points[(span_u - pu + i) * s.countV() + span_v - pv];
    double z = 0.0;
    double zy = 0.0;
    double zyy = 0.0;
    for (std::size_t j = 0; j <= pv; ++j) {
      z += nv0[j] * row[j].z();
      zy += nv1[j] * row[j].z();
      zyy += nv2[j] * row[j].z();
    }
    const double n0 = nu[i];
    const double n1 = nu[pu + 1 + i];
    jet.z += n0 * z;
    jet.zx += n1 * z;
    jet.zy += n0 * zy;
    jet.zxx += nu[2 * (pu + 1) + i] * z;
    jet.zxy += n1 * zy;
    jet.zyy += n0 * zyy;
  }
  return jet;
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
  const double mean = -((1.0 + jet.zy * jet.zy) * jet.zxx - 2.0 * jet.zx * jet.zy * jet.zxy +
                        (1.0 + jet.zx * jet.zx) * jet.zyy) / (2.0 * w2 * std::sqrt(w2));
  const double gauss = (jet.zxx * jet.zyy - jet.zxy * jet.zxy) / (w2 * w2);
  return mean - std::sqrt(std::max(0.0, mean * mean - gauss));
}

}  // namespace scan_to_path::toolpath
