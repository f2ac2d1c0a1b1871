// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "scan_to_path/nurbs/surface.h"

namespace scan_to_path::nurbs {

/// A height over the (u, v) plane with its partial derivatives.
struct HeightDerivatives {
  double w = 0.0;   ///< [m]
  double u = 0.0;   ///< dw/du
  double v = 0.0;   ///< dw/dv
  double uu = 0.0;  ///< [1/m]
  double uv = 0.0;  ///< [1/m]
  double vv = 0.0;  ///< [1/m]
};

/// Upward normal (-dw/du, -dw/dv, 1), of unit length, in (u, v, w).
Vector3 heightNormal(const HeightDerivatives& height);

/// A bicubic height function w(u, v) in power form, one polynomial per patch, for evaluating it millions of times:
/// some 20 ns a point. Outside its rectangle the polynomials of the border patches go on.
class HeightSurface {
public:
  HeightSurface() = default;

  /// From a surface whose points are (u, v, w): bicubic, no weights, the first two coordinates of its control points
  /// at the Greville abscissae (as fitHeightSurface makes it). Throws InputError for any other.
  explicit HeightSurface(const Surface& surface);

  double height(double u, double v) const;
  HeightDerivatives at(double u, double v) const;

  double firstU() const { return u_.first; }
  double lastU() const { return u_.last; }
  double firstV() const { return v_.first; }
  double lastV() const { return v_.last; }

private:
  /// Spans of one direction with a uniform table that finds them in O(1).
  struct Axis {
    struct Span {
      double centre;
      double inverse_half;
      double end;
    };
    double first = 0.0;
    double last = 0.0;
    double cells_per_unit = 0.0;
    std::vector<Span> spans;
    std::vector<std::size_t> span_at_cell;

    explicit Axis(const std::vector<double>& knots);
    Axis() = default;
    std::size_t find(double parameter) const;
  };
  using Patch = std::array<double, 16>;  ///< coefficient of s^k t^l at [4 k + l]

  const Patch& patch(std::size_t span_u, std::size_t span_v) const {
    return patches_[span_u * v_.spans.size() + span_v];
  }

  Axis u_;
  Axis v_;
  std::vector<Patch> patches_;
};

}  // namespace scan_to_path::nurbs
