// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/analytic_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/geometry/worlds.h"
#include "support/surface_oracle.h"

namespace scan_to_path::geometry {
namespace {

TEST(AnalyticSurface, SignedDistanceIsNegativeInside) {
  const Sphere sphere(0.1);
  EXPECT_NEAR(signedDistance(sphere, {0.0, 0.13, 0.0}), 0.03, 1e-16);
  EXPECT_NEAR(signedDistance(sphere, {0.0, 0.0, -0.06}), -0.04, 1e-16);
  EXPECT_EQ(signedDistance(Plane(), {7.0, 8.0, -0.5}), -0.5);
}

TEST(AnalyticSurface, SignedDistanceBesideAnOpenSurfaceHasTheTangentPlanesSide) {
  const FlatPart part({0.0, 1.0, 0.0, 1.0});
  EXPECT_NEAR(signedDistance(part, {1.3, 0.5, 0.4}), 0.5, 1e-16);
  EXPECT_NEAR(signedDistance(part, {1.3, 0.5, -0.4}), -0.5, 1e-16);
}

TEST(AnalyticSurface, PrincipalCurvaturesAreTheEigenvaluesOfTheShapeOperator) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    Eigen::Matrix2d shape;
    shape << random.gaussian(), random.gaussian(), 0.0, random.gaussian();
    shape(1, 0) = shape(0, 1);
    const Frame T = test::randomFrame(random);
    const Vector3 t1 = T.linear().col(0);
    const Vector3 t2 = T.linear().col(1);
    const PrincipalCurvatures k = principalCurvatures(shape(0, 0), shape(0, 1), shape(1, 1), t1, t2);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> expected(shape);
    // A few roundings of entries of about 1.
    EXPECT_NEAR(k.k_min, expected.eigenvalues()[0], 1e-14);
    EXPECT_NEAR(k.k_max, expected.eigenvalues()[1], 1e-14);
    const Eigen::Vector2d v_max(k.direction_max.dot(t1), k.direction_max.dot(t2));
    const Eigen::Vector2d v_min(k.direction_min.dot(t1), k.direction_min.dot(t2));
    EXPECT_LT((shape * v_max - k.k_max * v_max).norm(), 1e-14);
    EXPECT_LT((shape * v_min - k.k_min * v_min).norm(), 1e-14);
    EXPECT_NEAR(k.direction_max.dot(k.direction_min), 0.0, 1e-15);
  }
}

TEST(AnalyticSurface, UmbilicHasSomeOrthogonalDirections) {
  const PrincipalCurvatures k = principalCurvatures(5.0, 0.0, 5.0, Vector3::UnitX(), Vector3::UnitY());
  EXPECT_EQ(k.k_min, 5.0);
  EXPECT_EQ(k.k_max, 5.0);
  EXPECT_EQ(k.direction_min.dot(k.direction_max), 0.0);
}

}  // namespace
}  // namespace scan_to_path::geometry
