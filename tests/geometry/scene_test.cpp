// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/scene.h"

#include <gtest/gtest.h>

#include <memory>

#include "scan_to_path/geometry/worlds.h"
#include "support/expect_input_error.h"
#include "support/surface_oracle.h"

namespace scan_to_path::geometry {
namespace {

std::shared_ptr<const Surface> sphereAt(const Vector3& centre) {
  return std::make_shared<PosedSurface>(std::make_shared<Sphere>(0.1), makeFrame(centre, Vector3::Zero()));
}

TEST(Scene, NearestSurfaceWinsInAnyOrder) {
  const Scene near_first({sphereAt({1, 0, 0}), sphereAt({2, 0, 0})});
  const Scene far_first({sphereAt({2, 0, 0}), sphereAt({1, 0, 0})});
  const Ray ray = {Vector3::Zero(), Vector3::UnitX()};
  EXPECT_NEAR(near_first.castRay(ray)->distance, 0.9, 1e-15);
  EXPECT_EQ(near_first.castRayAtAll(ray)->surface, 0U);
  EXPECT_EQ(far_first.castRayAtAll(ray)->surface, 1U);
  EXPECT_EQ(near_first.castRayAtAll({{3, 0, 0}, -Vector3::UnitX()})->surface, 1U);
  EXPECT_FALSE(near_first.castRay(ray, 0.8));
  EXPECT_FALSE(near_first.castRay({Vector3::Zero(), Vector3::UnitZ()}));
}

TEST(Scene, ClosestPointIsTheNearestOfAll) {
  const Scene scene({sphereAt({1, 0, 0}), sphereAt({2, 0, 0})});
  EXPECT_LT((scene.closestPoint({1.6, 0, 0}).point - Vector3(1.9, 0, 0)).norm(), 1e-15);
  EXPECT_LT((scene.closestPoint({1.4, 0, 0}).point - Vector3(1.1, 0, 0)).norm(), 1e-15);
}

TEST(Scene, CurvatureDirectionsTurnWithTheSurface) {
  Random random(1);
  const Frame T = test::randomFrame(random);
  const PrincipalCurvatures k = Cylinder(0.1).curvatures({0.1, 0, 0});
  const PrincipalCurvatures moved = transformed(T, k);
  EXPECT_EQ(moved.k_min, 0.0);
  EXPECT_DOUBLE_EQ(moved.k_max, 10.0);
  EXPECT_LT((moved.direction_min - T.linear() * Vector3::UnitZ()).norm(), 1e-15);
}

TEST(Scene, RefusesMissingSurfaces) {
  test::expectInputError([] { Scene({}); }, "no surface given");
  test::expectInputError([] { Scene({sphereAt({0, 0, 0}), nullptr}); }, "surface 1 is missing");
  test::expectInputError([] { PosedSurface(nullptr, Frame::Identity()); }, "no surface given");
}

}  // namespace
}  // namespace scan_to_path::geometry
