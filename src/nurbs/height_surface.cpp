// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/height_surface.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"

#include "cubic.h"

namespace scan_to_path::nurbs {
namespace {

/// A span that is not empty with the power form of its basis functions and the number of the first of them.
struct BasisSpan {
  std::size_t first;
  CubicSpanMatrix matrix;
};

std::vector<BasisSpan> basisSpans(const std::vector<double>& knots) {
  std::vector<BasisSpan> spans;
  for (std::size_t i = degree; i + degree + 1 < knots.size(); ++i) {
    if (knots[i] < knots[i + 1]) spans.push_back({i - degree, cubicSpanMatrix(&knots[i - 2])});
  }
  return spans;
}

void checkHeightSurface(const Surface& surface) {
  validate(surface);
  if (surface.degree_u != 3 || surface.degree_v != 3) {
    throw InputError("height surface", "degree",
                     std::to_string(surface.degree_u) + " x " + std::to_string(surface.degree_v), "3 x 3");
  }
  if (!surface.weights.empty()) throw InputError("height surface", "weights", "given", "absent");
  const std::vector<double> u = grevilleAbscissae(surface.knots_u, 3);
  const std::vector<double> v = grevilleAbscissae(surface.knots_v, 3);
  // Greville abscissae are means of three knots: their rounding is some units in the last place of the largest.
  const auto near = [](double a, double b, double scale) { return std::abs(a - b) <= 1e-12 * scale; };
  const double scale_u = std::max(std::abs(surface.knots_u.front()), std::abs(surface.knots_u.back()));
  const double scale_v = std::max(std::abs(surface.knots_v.front()), std::abs(surface.knots_v.back()));
  for (std::size_t i = 0; i < u.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) {
      const Vector3& point = surface.control_points[i * v.size() + j];
      if (!near(point.x(), u[i], scale_u) || !near(point.y(), v[j], scale_v)) {
        throw InputError("height surface", "control point " + std::to_string(i * v.size() + j),
                         "off its Greville abscissae", "above them");
      }
    }
  }
}

}  // namespace

Vector3 heightNormal(const HeightDerivatives& height) {
  return Vector3(-height.u, -height.v, 1.0) / std::sqrt(1.0 + height.u * height.u + height.v * height.v);
}

HeightSurface::Axis::Axis(const std::vector<double>& knots) : first(knots.front()), last(knots.back()) {
  for (std::size_t i = degree; i + degree + 1 < knots.size(); ++i) {
    const double half = 0.5 * (knots[i + 1] - knots[i]);
    if (half > 0.0) spans.push_back({knots[i] + half, 1.0 / half, knots[i + 1]});
  }
  const std::size_t cells = 4 * spans.size();  // at most one span begins in most of them
  cells_per_unit = static_cast<double>(cells) / (last - first);
  std::size_t span = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    const double start = first + static_cast<double>(c) / cells_per_unit;
    while (span + 1 < spans.size() && spans[span].end <= start) ++span;
    span_at_cell.push_back(span);
  }
}

std::size_t HeightSurface::Axis::find(double parameter) const {
  const double cell = (parameter - first) * cells_per_unit;
  // Written so that a parameter that is not a number ends in cell 0.
  const double inside = cell > 0.0 ? std::min(cell, static_cast<double>(span_at_cell.size() - 1)) : 0.0;
  std::size_t span = span_at_cell[static_cast<std::size_t>(inside)];
  while (span + 1 < spans.size() && parameter >= spans[span].end) ++span;
  return span;
}

HeightSurface::HeightSurface(const Surface& surface) {
  checkHeightSurface(surface);
  u_ = Axis(surface.knots_u);
  v_ = Axis(surface.knots_v);
  const std::vector<BasisSpan> spans_u = basisSpans(surface.knots_u);
  const std::vector<BasisSpan> spans_v = basisSpans(surface.knots_v);
  patches_.reserve(spans_u.size() * spans_v.size());
  for (const BasisSpan& span_u : spans_u) {
    for (const BasisSpan& span_v : spans_v) {
      Patch patch{};
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
          const double w = surface.control_points[(span_u.first + i) * surface.countV() + span_v.first + j].z();
          for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t l = 0; l < 4; ++l) patch[4 * k + l] += w * span_u.matrix[k][i] * span_v.matrix[l][j];
          }
        }
      }
      patches_.push_back(patch);
    }
  }
}

double HeightSurface::height(double u, double v) const {
  const std::size_t span_u = u_.find(u);
  const std::size_t span_v = v_.find(v);
  const double s = (u - u_.spans[span_u].centre) * u_.spans[span_u].inverse_half;
  const double t = (v - v_.spans[span_v].centre) * v_.spans[span_v].inverse_half;
  const Patch& a = patch(span_u, span_v);
  double row[4];
  for (std::size_t l = 0; l < 4; ++l) row[l] = ((a[12 + l] * s + a[8 + l]) * s + a[4 + l]) * s + a[l];
  return ((row[3] * t + row[2]) * t + row[1]) * t + row[0];
}

HeightDerivatives HeightSurface::at(double u, double v) const {
  const std::size_t span_u = u_.find(u);
  const std::size_t span_v = v_.find(v);
  const double du = u_.spans[span_u].inverse_half;
  const double dv = v_.spans[span_v].inverse_half;
  const double s = (u - u_.spans[span_u].centre) * du;
  const double t = (v - v_.spans[span_v].centre) * dv;
  const Patch& a = patch(span_u, span_v);
  double row[4];  // polynomials in t: the patch at s, and its derivatives by s
  double row_s[4];
  double row_ss[4];
  for (std::size_t l = 0; l < 4; ++l) {
    row[l] = ((a[12 + l] * s + a[8 + l]) * s + a[4 + l]) * s + a[l];
    row_s[l] = (3.0 * a[12 + l] * s + 2.0 * a[8 + l]) * s + a[4 + l];
    row_ss[l] = 6.0 * a[12 + l] * s + 2.0 * a[8 + l];
  }
  const auto value = [t](const double* c) { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; };
  const auto slope = [t](const double* c) { return (3.0 * c[3] * t + 2.0 * c[2]) * t + c[1]; };
  HeightDerivatives result;
  result.w = value(row);
  result.u = value(row_s) * du;
  result.v = slope(row) * dv;
  result.uu = value(row_ss) * du * du;
  result.uv = slope(row_s) * du * dv;
  result.vv = (6.0 * row[3] * t + 2.0 * row[2]) * dv * dv;
  return result;
}

}  // namespace scan_to_path::nurbs
