// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "scan_to_path/geometry/height_field.h"

namespace scan_to_path::geometry {
namespace {

constexpr double length = 0.24;                // along x [m]
constexpr double width = 0.16;                 // along y [m]
constexpr double along = 2.0 * M_PI / length;  // wave numbers [rad/m]
constexpr double across = M_PI / width;
constexpr double a = 0.020;  // amplitudes [m]
constexpr double b = 0.004;
constexpr double c = 0.003;

// |f| <= a + b + c; the Hessian's norm is at most its largest diagonal entry plus the other one.
constexpr HeightField::Bounds bounds = {-(a + b + c), a + b + c, (a + c) * along* along + c* along* across};

}  // namespace

SPart::SPart() : HeightField({0.0, length, 0.0, width}, bounds) {}

HeightJet SPart::jet(double x, double y) const {
  // sin(2 pi (x - 0.12) / 0.24) = -sin(2 pi x / 0.24) and cos(pi (y - 0.08) / 0.16) = sin(pi y / 0.16).
  const double sx = std::sin(along * x);
  const double cx = std::cos(along * x);
  const double sy = std::sin(across * y);
  const double cy = std::cos(across * y);
  return {-a * sx + b * sy + c * sx * sy,    along * cx * (-a + c * sy),   across * cy * (b + c * sx),
          along * along * sx * (a - c * sy), along * across * c * cx * cy, -across * across * sy * (b + c * sx)};
}

}  // namespace scan_to_path::geometry
