// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "scan_to_path/scan/between_rows.h"
#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::test {

using Height = std::function<double(double, double)>;

/// A clamped cubic basis on uniform knots and the matrix that interpolates at its Greville abscissae.
struct CubicBasis {
  std::vector<double> knots;
  std::vector<double> abscissae;
  Eigen::PartialPivLU<Eigen::MatrixXd> collocation;

  CubicBasis(double first, double last, int count)
      : knots(nurbs::clampedUniformKnots(first, last, count, 3)), abscissae(nurbs::grevilleAbscissae(knots, 3)) {
    Eigen::MatrixXd N = Eigen::MatrixXd::Zero(count, count);
    for (int i = 0; i < count; ++i) {
      double values[4];
      const std::size_t span = nurbs::findSpan(knots, 3, abscissae[static_cast<std::size_t>(i)]);
      nurbs::basisFunctions(knots, 3, span, abscissae[static_cast<std::size_t>(i)], values);
      for (int j = 0; j < 4; ++j) N(i, static_cast<int>(span) - 3 + j) = values[j];
    }
    collocation.compute(N);
  }
};

/// The bicubic surface that interpolates z = f(x, y) at count_x by count_y places of the rectangle.
inline nurbs::Surface heightSurface(const Height& f, const geometry::Rectangle& area, int count_x, int count_y) {
  const CubicBasis bx(area.x_min, area.x_max, count_x);
  const CubicBasis by(area.y_min, area.y_max, count_y);
  Eigen::MatrixXd Z(count_x, count_y);
  for (int i = 0; i < count_x; ++i) {
    for (int j = 0; j < count_y; ++j) {
      Z(i, j) = f(bx.abscissae[static_cast<std::size_t>(i)], by.abscissae[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::MatrixXd C = by.collocation.solve(bx.collocation.solve(Z).transpose()).transpose();
  nurbs::Surface surface;
  surface.knots_u = bx.knots;
  surface.knots_v = by.knots;
  for (int i = 0; i < count_x; ++i) {
    for (int j = 0; j < count_y; ++j) {
      surface.control_points.emplace_back(bx.abscissae[static_cast<std::size_t>(i)],
                                          by.abscissae[static_cast<std::size_t>(j)], C(i, j));
    }
  }
  return surface;
}

/// The section of f at y as a cubic curve over x, in the frame T.
inline nurbs::Curve heightLine(const Height& f, double x_min, double x_max, double y, int count,
                               const geometry::Frame& T) {
  const CubicBasis basis(x_min, x_max, count);
  Eigen::VectorXd z(count);
  for (int i = 0; i < count; ++i) z[i] = f(basis.abscissae[static_cast<std::size_t>(i)], y);
  const Eigen::VectorXd c = basis.collocation.solve(z);
  nurbs::Curve curve;
  curve.knots = basis.knots;
  for (int i = 0; i < count; ++i) {
    curve.control_points.push_back(T * geometry::Vector3(basis.abscissae[static_cast<std::size_t>(i)], y, c[i]));
  }
  return curve;
}

/// What a noise-free scan of z = f(x, y) over a rectangle would be fitted to, in the frame T: lines along x, about
/// `pitch` apart, the surface and the outline.
inline scan::FittedScan fittedScan(const Height& f, const geometry::Rectangle& area, double pitch, int count_x,
                                   int count_y, const geometry::Frame& T = geometry::Frame::Identity()) {
  scan::FittedScan scan;
  scan.T_cloud_scan = T;
  scan.surface = heightSurface(f, area, count_x, count_y);
  scan.outline.polygons = {
      {{area.x_min, area.y_min}, {area.x_max, area.y_min}, {area.x_max, area.y_max}, {area.x_min, area.y_max}}};
  const int rows = static_cast<int>((area.y_max - area.y_min) / pitch + 0.5) + 1;
  scan.pitch = (area.y_max - area.y_min) / (rows - 1);
  for (int row = 0; row < rows; ++row) {
    scan::FittedLine line;
    line.row = row;
    line.forward = row % 2 == 0;
    line.curve = heightLine(f, area.x_min, area.x_max, area.y_min + row * scan.pitch, count_x, T);
    line.begin = area.x_min;
    line.end = area.x_max;
    scan.lines.push_back(std::move(line));
  }
  scan.between_rows_share = scan::estimateBetweenRows(scan).share;
  return scan;
}

/// The S part, to some nanometres.
inline scan::FittedScan fittedSPart(const geometry::Frame& T = geometry::Frame::Identity()) {
  const geometry::SPart part;
  return fittedScan([&part](double x, double y) { return part.jet(x, y).z; }, part.rectangle(), 4e-3, 121, 81, T);
}

}  // namespace scan_to_path::test
