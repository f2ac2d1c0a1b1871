// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/height_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scan_to_path/common/random.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "support/expect_input_error.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;

Surface randomHeights(Random& random, int count_u, int count_v) {
  Surface surface;
  surface.knots_u = clampedUniformKnots(-0.2, 0.4, count_u, 3);
  surface.knots_v = clampedUniformKnots(1.0, 1.5, count_v, 3);
  const double spread = 0.3 * 0.6 / count_u;
  for (int i = 4; i < count_u; ++i) surface.knots_u[static_cast<std::size_t>(i)] += random.uniform(-spread, spread);
  if (count_v > 6) surface.knots_v[5] = surface.knots_v[6];  // a double knot: C1 there
  for (const double u : grevilleAbscissae(surface.knots_u, 3)) {
    for (const double v : grevilleAbscissae(surface.knots_v, 3)) {
      surface.control_points.emplace_back(u, v, random.gaussian());
    }
  }
  return surface;
}

TEST(HeightSurface, AgreesWithTheSurface) {
  Random random(1);
  for (int round = 0; round < 30; ++round) {
    const Surface surface = randomHeights(random, 4 + round % 9, 4 + round % 5);
    const HeightSurface heights(surface);
    for (int k = 0; k < 50; ++k) {
      const double u = random.uniform(-0.3, 0.5);  // a little beyond the border too
      const double v = random.uniform(0.95, 1.55);
      const SurfaceDerivatives S = evaluate(surface, u, v);
      const HeightDerivatives h = heights.at(u, v);
      // Extrapolated powers grow to some 1e3; derivatives by spans of down to 0.02 bring 50 and 2500 more.
      EXPECT_NEAR(S.point.x(), u, 1e-11);
      EXPECT_NEAR(S.point.y(), v, 1e-11);
      EXPECT_NEAR(h.w, S.point.z(), 1e-10);
      EXPECT_EQ(h.w, heights.height(u, v));
      EXPECT_NEAR(h.u, S.u.z(), 1e-8);
      EXPECT_NEAR(h.v, S.v.z(), 1e-8);
      EXPECT_NEAR(h.uu, S.uu.z(), 1e-6);
      EXPECT_NEAR(h.uv, S.uv.z(), 1e-6);
      EXPECT_NEAR(h.vv, S.vv.z(), 1e-6);
      EXPECT_NEAR(heightNormal(h).dot(S.u.cross(S.v).normalized()), 1.0, 1e-9);
    }
  }
}

TEST(HeightSurface, KnotsBelongToTheSpanAfterThem) {
  Random random(2);
  const Surface surface = randomHeights(random, 12, 9);
  const HeightSurface heights(surface);
  for (const double u : surface.knots_u) {
    for (const double v : surface.knots_v) EXPECT_NEAR(heights.height(u, v), evaluate(surface, u, v).point.z(), 1e-13);
  }
}

TEST(HeightSurface, ParametersThatAreNoNumbersGiveNone) {
  Random random(3);
  const HeightSurface heights(randomHeights(random, 6, 6));
  EXPECT_TRUE(std::isnan(heights.height(NAN, 1.2)));
  EXPECT_TRUE(std::isnan(heights.at(0.1, NAN).w));
  EXPECT_FALSE(std::isfinite(heights.height(std::numeric_limits<double>::infinity(), 1.2)));
}

TEST(HeightSurface, RefusesSurfacesThatAreNoHeightFunctions) {
  Random random(4);
  const Surface good = randomHeights(random, 6, 6);
  Surface bad = good;
  bad.control_points[3].x() += 1e-6;
  expectInputError([&] { HeightSurface{bad}; }, "control point 3");
  bad = good;
  bad.weights.assign(36, 1.0);
  expectInputError([&] { HeightSurface{bad}; }, "weights");
  bad = good;
  bad.degree_v = 2;
  expectInputError([&] { HeightSurface{bad}; }, "surface");
  bad = good;
  bad.control_points.pop_back();
  expectInputError([&] { HeightSurface{bad}; }, "number of control points");
}

}  // namespace
}  // namespace scan_to_path::nurbs
