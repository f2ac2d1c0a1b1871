// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "scan_to_path/nurbs/curve.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "support/expect_input_error.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;

Surface randomSurface(Random& random, bool rational) {
  Surface surface;
  surface.degree_u = 3;
  surface.degree_v = 2;
  surface.knots_u = clampedUniformKnots(0.0, 1.0, 7, 3);
  surface.knots_v = clampedUniformKnots(-1.0, 1.0, 5, 2);
  for (int i = 0; i < 7 * 5; ++i) {
    surface.control_points.emplace_back(random.gaussian(), random.gaussian(), random.gaussian());
    if (rational) surface.weights.push_back(random.uniform(0.5, 2.0));
  }
  return surface;
}

/// The surface's isoparametric curve at v, control point by control point in homogeneous coordinates.
Curve isoCurve(const Surface& surface, double v) {
  Curve curve;
  curve.degree = surface.degree_u;
  curve.knots = surface.knots_u;
  for (std::size_t i = 0; i < surface.countU(); ++i) {
    Curve points;
    Curve weights;
    points.degree = weights.degree = surface.degree_v;
    points.knots = weights.knots = surface.knots_v;
    for (std::size_t j = 0; j < surface.countV(); ++j) {
      const std::size_t index = i * surface.countV() + j;
      const double w = surface.weights.empty() ? 1.0 : surface.weights[index];
      points.control_points.push_back(w * surface.control_points[index]);
      weights.control_points.emplace_back(w, 0.0, 0.0);
    }
    const double w = pointAt(weights, v).x();
    curve.control_points.push_back(pointAt(points, v) / w);
    curve.weights.push_back(w);
  }
  return curve;
}

TEST(Surface, AgreesWithItsIsoparametricCurves) {
  Random random(1);
  for (int round = 0; round < 60; ++round) {
    const Surface surface = randomSurface(random, round % 2 == 0);
    const double u = round == 0 ? 1.0 : random.uniform(0.0, 1.0);
    const double v = round == 0 ? 1.0 : random.uniform(-1.0, 1.0);
    const SurfaceDerivatives S = evaluate(surface, u, v);
    const CurvePoint C = evaluate(isoCurve(surface, v), u);
    EXPECT_LT((S.point - C.point).norm(), 1e-13);
    EXPECT_LT((S.u - C.first).norm(), 1e-11);
    EXPECT_LT((S.uu - C.second).norm(), 1e-9);
  }
}

TEST(Surface, DerivativesAgreeWithDifferences) {
  Random random(2);
  constexpr double h = 1e-5;
  for (int round = 0; round < 60; ++round) {
    const Surface surface = randomSurface(random, round % 2 == 0);
    const double u = random.uniform(0.01, 0.99);
    const double v = random.uniform(-0.99, 0.99);
    if (findSpan(surface.knots_v, 2, v - h) != findSpan(surface.knots_v, 2, v + h)) continue;  // S_vv jumps at knots
    const SurfaceDerivatives S = evaluate(surface, u, v);
    const SurfaceDerivatives above = evaluate(surface, u, v + h);
    const SurfaceDerivatives below = evaluate(surface, u, v - h);
    // h^2 / 6 times third derivatives below 1e5.
    EXPECT_LT((S.v - (above.point - below.point) / (2 * h)).norm(), 1e-5);
    EXPECT_LT((S.uv - (above.u - below.u) / (2 * h)).norm(), 1e-4);
    EXPECT_LT((S.vv - (above.v - below.v) / (2 * h)).norm(), 1e-4);
  }
}

TEST(Surface, RationalQuarterCylinderHasItsRadius) {
  Surface cylinder;
  cylinder.degree_u = 2;
  cylinder.degree_v = 1;
  cylinder.knots_u = {0, 0, 0, 1, 1, 1};
  cylinder.knots_v = {0, 0, 1, 1};
  for (const Vector3& p : {Vector3(2, 0, 0), Vector3(2, 2, 0), Vector3(0, 2, 0)}) {
    cylinder.control_points.push_back(p);
    cylinder.control_points.push_back(p + Vector3::UnitZ());
  }
  const double w = std::sqrt(0.5);
  cylinder.weights = {1, 1, w, w, 1, 1};
  EXPECT_NO_THROW(validate(cylinder));
  for (double u = 0.0; u <= 1.0; u += 0.125) {
    const SurfaceDerivatives S = evaluate(cylinder, u, 0.3);
    EXPECT_NEAR(S.point.head<2>().norm(), 2.0, 1e-14);
    const Vector3 normal = S.u.cross(S.v).normalized();
    EXPECT_NEAR(std::abs(normal.dot(Vector3(S.point.x(), S.point.y(), 0.0))), 2.0, 1e-13);
    EXPECT_NEAR(std::abs(S.uu.dot(normal)) / S.u.squaredNorm(), 0.5, 1e-12);
  }
}

TEST(Surface, ValidateNamesWhatIsWrong) {
  Random random(3);
  const Surface good = randomSurface(random, true);
  EXPECT_NO_THROW(validate(good));
  Surface bad = good;
  bad.control_points.pop_back();
  expectInputError([&] { validate(bad); }, "number of control points is 34, must be 7 x 5");
  bad = good;
  bad.weights[4] = -1.0;
  expectInputError([&] { validate(bad); }, "surface: weight 4");
  bad = good;
  bad.knots_v[3] = NAN;
  expectInputError([&] { validate(bad); }, "direction v: knot 3");
  expectInputError([] { validate(Surface{}); }, "surface, direction u");
  bad = good;
  bad.degree_u = -3;
  expectInputError([&] { validate(bad); }, "degree");
}

}  // namespace
}  // namespace scan_to_path::nurbs
