// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "support/expect_input_error.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;

Curve randomCurve(Random& random, int degree, int control_points, bool rational) {
  Curve curve;
  curve.degree = degree;
  curve.knots = clampedUniformKnots(0.0, 2.0, control_points, degree);
  for (std::size_t i = curve.knots.size() - 1; i-- > static_cast<std::size_t>(degree) + 1;) {
    if (i < static_cast<std::size_t>(control_points)) curve.knots[i] += random.uniform(-0.05, 0.05);
  }
  for (int i = 0; i < control_points; ++i) {
    curve.control_points.emplace_back(random.gaussian(), random.gaussian(), random.gaussian());
    if (rational) curve.weights.push_back(random.uniform(0.5, 2.0));
  }
  return curve;
}

/// de Boor's corner cutting in homogeneous coordinates: an evaluation that knows no basis functions.
Vector3 deBoor(const Curve& curve, double u) {
  const std::size_t p = static_cast<std::size_t>(curve.degree);
  const std::size_t span = findSpan(curve.knots, curve.degree, u);
  std::vector<Eigen::Vector4d> d;
  for (std::size_t i = span - p; i <= span; ++i) {
    const double w = curve.weights.empty() ? 1.0 : curve.weights[i];
    d.emplace_back((Eigen::Vector4d() << w * curve.control_points[i], w).finished());
  }
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const std::size_t i = span - p + j;
      const double alpha = (u - curve.knots[i]) / (curve.knots[i + p + 1 - r] - curve.knots[i]);
      d[j] = (1.0 - alpha) * d[j - 1] + alpha * d[j];
    }
  }
  return d[p].head<3>() / d[p].w();
}

/// Quarter circle of radius 1 as a rational quadratic.
Curve quarterCircle() {
  return {2, {0, 0, 0, 1, 1, 1}, {Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(0, 1, 0)}, {1.0, std::sqrt(0.5), 1.0}};
}

TEST(Curve, EvaluatesAsDeBoor) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const int degree = 1 + round % 5;
    const Curve curve = randomCurve(random, degree, 12, round % 2 == 0);
    const double u = round == 0 ? 2.0 : random.uniform(0.0, 2.0);
    EXPECT_LT((evaluate(curve, u).point - deBoor(curve, u)).norm(), 1e-13);
    EXPECT_LT((pointAt(curve, u) - deBoor(curve, u)).norm(), 1e-13);
  }
}

TEST(Curve, DerivativesAgreeWithDifferences) {
  Random random(2);
  constexpr double h = 1e-4;
  for (int round = 0; round < 100; ++round) {
    const Curve curve = randomCurve(random, 3, 10, round % 2 == 0);
    const double u = random.uniform(2 * h, 2.0 - 2 * h);
    if (findSpan(curve.knots, 3, u - h) != findSpan(curve.knots, 3, u + h)) continue;  // C''' jumps at knots
    const CurvePoint at = evaluate(curve, u);
    const Vector3 first = (pointAt(curve, u + h) - pointAt(curve, u - h)) / (2 * h);
    const Vector3 second = (pointAt(curve, u + h) - 2 * at.point + pointAt(curve, u - h)) / (h * h);
    // h^2 / 6 |C'''| and h^2 / 12 |C''''| with control points of size 3 on spans of 0.2: 1e-8 * 1e4 and 1e-8 * 1e6.
    EXPECT_LT((at.first - first).norm(), 3e-4);
    EXPECT_LT((at.second - second).norm(), 3e-2);
  }
}

TEST(Curve, RationalQuadraticIsACircle) {
  const Curve circle = quarterCircle();
  for (double u = 0.0; u <= 1.0; u += 0.0625) {
    const CurvePoint at = evaluate(circle, u);
    EXPECT_NEAR(at.point.norm(), 1.0, 1e-15);
    EXPECT_NEAR(at.point.dot(at.first), 0.0, 1e-14);
    const double curvature = at.first.cross(at.second).norm() / std::pow(at.first.norm(), 3);
    EXPECT_NEAR(curvature, 1.0, 1e-13);
  }
}

TEST(Curve, OutsideItsDomainTheEndPolynomialGoesOn) {
  Curve parabola;  // (u, u^2, u^3) on [0, 1] in four Bernstein coefficients
  parabola.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  parabola.control_points = {Vector3(0, 0, 0), Vector3(1. / 3, 0, 0), Vector3(2. / 3, 1. / 3, 0), Vector3(1, 1, 1)};
  for (const double u : {-0.5, 1.5}) {
    EXPECT_LT((pointAt(parabola, u) - Vector3(u, u * u, u * u * u)).norm(), 1e-14);
    EXPECT_LT((evaluate(parabola, u).second - Vector3(0, 2, 6 * u)).norm(), 1e-12);
  }
}

TEST(Curve, KnotInsertionLeavesTheCurveUnchanged) {
  Random random(3);
  for (int round = 0; round < 100; ++round) {
    const Curve curve = randomCurve(random, 1 + round % 4, 9, round % 2 == 0);
    Curve refined = curve;
    for (int i = 0; i < 5; ++i) refined = insertKnot(refined, random.uniform(0.01, 1.99));
    EXPECT_NO_THROW(validate(refined));
    EXPECT_EQ(refined.control_points.size(), curve.control_points.size() + 5);
    for (double u = 0.0; u <= 2.0; u += 0.125) {
      EXPECT_LT((pointAt(refined, u) - pointAt(curve, u)).norm(), 1e-13);
    }
  }
}

TEST(Curve, KnotInsertionAtAnExistingKnotUpToTheDegree) {
  Random random(4);
  const Curve curve = randomCurve(random, 3, 8, true);
  const double u = curve.knots[5];
  Curve refined = insertKnot(insertKnot(curve, u), u);
  EXPECT_LT((pointAt(refined, u) - pointAt(curve, u)).norm(), 1e-14);
  EXPECT_LT((pointAt(refined, 0.9 * u) - pointAt(curve, 0.9 * u)).norm(), 1e-13);
  expectInputError([&] { insertKnot(refined, u); }, "fewer than degree times");
  expectInputError([&] { insertKnot(curve, 0.0); }, "knot to insert");
  expectInputError([&] { insertKnot(curve, NAN); }, "knot to insert");
}

TEST(Curve, ValidateNamesWhatIsWrong) {
  Curve curve = quarterCircle();
  EXPECT_NO_THROW(validate(curve));
  curve.weights[1] = 0.0;
  expectInputError([&] { validate(curve); }, "curve: weight 1");
  curve.weights.pop_back();
  expectInputError([&] { validate(curve); }, "number of weights is 2, must be 0 or 3");
  curve.weights.clear();
  curve.control_points[2].y() = INFINITY;
  expectInputError([&] { validate(curve); }, "control point 2");
  curve.control_points.pop_back();
  expectInputError([&] { validate(curve); }, "curve");
  expectInputError([] { validate(Curve{}); }, "curve");
}

}  // namespace
}  // namespace scan_to_path::nurbs
