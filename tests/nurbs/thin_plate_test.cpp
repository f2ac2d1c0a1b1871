// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../../src/nurbs/thin_plate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "scan_to_path/nurbs/height_surface.h"
#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::nurbs {
namespace {

Surface heights(int count_u, int count_v, double (*w)(double, double), Random* random) {
  Surface surface;
  surface.knots_u = clampedUniformKnots(0.0, 2.0, count_u, 3);
  surface.knots_v = clampedUniformKnots(0.0, 1.0, count_v, 3);
  for (const double u : grevilleAbscissae(surface.knots_u, 3)) {
    for (const double v : grevilleAbscissae(surface.knots_v, 3)) {
      surface.control_points.emplace_back(u, v, random != nullptr ? random->gaussian() : w(u, v));
    }
  }
  return surface;
}

/// c^T A c with the thin-plate matrix, in either order of the unknowns.
double energy(const Surface& surface, bool v_fastest) {
  const std::size_t stride_u = v_fastest ? surface.countV() : 1;
  const std::size_t stride_v = v_fastest ? 1 : surface.countU();
  BandedMatrix A(surface.countU() * surface.countV(), 3 * (stride_u + stride_v));
  addThinPlate(surface, 0.5, stride_u, stride_v, A);
  std::vector<double> c(A.size());
  for (std::size_t i = 0; i < surface.countU(); ++i) {
    for (std::size_t j = 0; j < surface.countV(); ++j) {
      c[i * stride_u + j * stride_v] = surface.control_points[i * surface.countV() + j].z();
    }
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < A.size(); ++i) {
    for (std::size_t j = i - std::min(i, A.bandwidth()); j <= i; ++j) {
      sum += (i == j ? 1.0 : 2.0) * A.at(i, j) * c[i] * c[j];
    }
  }
  return sum;
}

TEST(ThinPlate, PlanesHaveNoEnergy) {
  const auto plane = [](double u, double v) { return 0.3 + 2.0 * u - v; };
  EXPECT_NEAR(energy(heights(7, 5, plane, nullptr), true), 0.0, 1e-9);  // rounding of terms of 1e4
}

TEST(ThinPlate, ProductHasTwiceTheAreaTimesItsTwist) {
  const auto product = [](double u, double v) { return 3.0 * u * v; };  // 0.5 * 2 * 3^2 over an area of 2
  EXPECT_NEAR(energy(heights(7, 5, product, nullptr), true), 18.0, 1e-9);
  EXPECT_NEAR(energy(heights(5, 7, product, nullptr), false), 18.0, 1e-9);
}

TEST(ThinPlate, AgreesWithNumericalIntegration) {
  Random random(1);
  const Surface surface = heights(6, 5, nullptr, &random);
  const HeightSurface w(surface);
  constexpr int steps = 600;  // multiples of both numbers of spans: the midpoint rule sees smooth pieces only
  double integral = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const HeightDerivatives h = w.at(2.0 * (i + 0.5) / steps, (j + 0.5) / steps);
      integral += h.uu * h.uu + 2.0 * h.uv * h.uv + h.vv * h.vv;
    }
  }
  const double expected = 0.5 * integral * 2.0 / (steps * steps);
  // Midpoint rule on 200 and 300 steps a span: relative error below (1 / 200)^2 times some 10.
  EXPECT_NEAR(energy(surface, true) / expected, 1.0, 3e-4);
  EXPECT_NEAR(energy(surface, false), energy(surface, true), 1e-9 * expected);
}

}  // namespace
}  // namespace scan_to_path::nurbs
