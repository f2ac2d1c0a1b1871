// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/height_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/geometry/worlds.h"
#include "support/expect_input_error.h"
#include "support/surface_oracle.h"

namespace scan_to_path::geometry {
namespace {

/// A wave that folds light: many crossings on a shallow ray.
class Wave : public HeightField {
public:
  Wave() : HeightField({-0.1, 0.1, -0.1, 0.1}, {-0.01, 0.01, 0.01 * 200 * 200}) {}
  HeightJet jet(double x, double) const override {
    return {0.01 * std::sin(200 * x), 2 * std::cos(200 * x), 0, -400 * std::sin(200 * x), 0, 0};
  }
};

TEST(HeightField, JetIsItsOwnDerivative) {
  const SPart part;
  const Saddle saddle(0.3, 0.1);
  const double h = 1e-5;
  Random random(1);
  for (const HeightField* field : {static_cast<const HeightField*>(&part), static_cast<const HeightField*>(&saddle)}) {
    for (int i = 0; i < 200; ++i) {
      const double x = random.uniform(-0.1, 0.2);
      const double y = random.uniform(-0.1, 0.1);
      const HeightJet jet = field->jet(x, y);
      const HeightJet east = field->jet(x + h, y);
      const HeightJet west = field->jet(x - h, y);
      const HeightJet north = field->jet(x, y + h);
      const HeightJet south = field->jet(x, y - h);
      // Rounding 1e-17 / h, truncation h^2 / 6 times a third derivative below 500.
      EXPECT_NEAR(jet.zx, (east.z - west.z) / (2 * h), 2e-8);
      EXPECT_NEAR(jet.zy, (north.z - south.z) / (2 * h), 2e-8);
      // Likewise with slopes up to 1 and fourth derivatives below 1e4.
      EXPECT_NEAR(jet.zxx, (east.zx - west.zx) / (2 * h), 1e-6);
      EXPECT_NEAR(jet.zxy, (north.zx - south.zx) / (2 * h), 1e-6);
      EXPECT_NEAR(jet.zyy, (north.zy - south.zy) / (2 * h), 1e-6);
    }
  }
}

TEST(HeightField, VerticalRayIsExact) {
  const SPart part;
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const double x = random.uniform(0, 0.24);
    const double y = random.uniform(0, 0.16);
    const auto hit = part.castRay({{x, y, 0.08}, -Vector3::UnitZ()});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->point, Vector3(x, y, part.jet(x, y).z));
    EXPECT_NEAR(hit->distance, 0.08 - part.jet(x, y).z, 1e-16);
  }
}

TEST(HeightField, BorderBelongsToThePartAndBeyondItTheTableIsSeen) {
  const auto table = std::make_shared<PosedSurface>(std::make_shared<Plane>(), makeFrame({0, 0, -0.024}, {0, 0, 0}));
  const Scene scene({std::make_shared<SPart>(), table});
  const auto surfaceBelow = [&](double x, double y) {
    return scene.castRayAtAll({{x, y, 0.08}, -Vector3::UnitZ()})->surface;
  };
  for (const double x : {0.0, 0.1, 0.24}) {
    for (const double y : {0.0, 0.1, 0.16}) EXPECT_EQ(surfaceBelow(x, y), 0U);
  }
  EXPECT_EQ(surfaceBelow(std::nextafter(0.24, 1.0), 0.1), 1U);
  EXPECT_EQ(surfaceBelow(0.1, std::nextafter(0.0, -1.0)), 1U);
  EXPECT_NEAR(scene.castRay({{-0.01, 0.1, 0.08}, -Vector3::UnitZ()})->distance, 0.104, 1e-16);
}

TEST(HeightField, FirstOfManyCrossingsIsFound) {
  const Wave wave;
  Random random(4);
  const auto implicit = [](const Vector3& p) {
    return std::abs(p.x()) <= 0.1 && std::abs(p.y()) <= 0.1 ? p.z() - 0.01 * std::sin(200 * p.x()) : std::nan("");
  };
  for (int i = 0; i < 300; ++i) {
    const Vector3 origin(-0.2, random.uniform(-0.05, 0.05), random.uniform(-0.02, 0.02));
    const Vector3 target(0.2, random.uniform(-0.05, 0.05), random.uniform(-0.02, 0.02));
    const Ray ray = {origin, (target - origin).normalized()};
    const auto hit = wave.castRay(ray);
    // 31 mm waves: a 0.1 mm step sees every crossing but touches flatter than 0.1 um.
    const double expected = test::marchedHit(implicit, ray, 0.5, 1e-4);
    ASSERT_EQ(hit.has_value(), !std::isnan(expected));
    if (hit) {
      EXPECT_NEAR(hit->distance, expected, 1e-12);
    }
  }
}

TEST(HeightField, TouchingRayEndsAndIsNotInvented) {
  const Wave wave;  // crests at z = 0.01
  const auto above = wave.castRay({{-0.2, 0, 0.01 + 1e-9}, Vector3::UnitX()});
  EXPECT_FALSE(above);
  const auto below = wave.castRay({{-0.2, 0, 0.01 - 1e-9}, Vector3::UnitX()});
  ASSERT_TRUE(below);
  // The first crest within the rectangle is at 200 x = -19.5 pi + ... = -5.5 pi; the ray cuts it sqrt(2 h / k) before.
  EXPECT_NEAR(below->point.x(), -5.5 * M_PI / 200 - std::sqrt(2e-9 / 400), 1e-9);
}

TEST(HeightField, ClosestPointBesideThePartIsOnItsBorder) {
  const SPart part;
  const SurfacePoint beside = part.closestPoint({-0.05, 0.08, 0.0});
  EXPECT_EQ(beside.point.x(), 0.0);
  const SurfacePoint corner = part.closestPoint({0.3, 0.2, 0.0});
  EXPECT_EQ(corner.point, Vector3(0.24, 0.16, part.jet(0.24, 0.16).z));
}

// Mutation twin: a bending bound that is too small lets the ray pass the first crossing, and the oracle sees it.
TEST(HeightField, TooSmallABendingBoundIsSeenByTheOracle) {
  class Careless : public Wave {
  public:
    std::optional<RayHit> firstByNewton(const Ray& ray) const {
      class Straight : public HeightField {
      public:
        Straight() : HeightField({-0.1, 0.1, -0.1, 0.1}, {-0.01, 0.01, 1.0}) {}
        HeightJet jet(double x, double y) const override { return Wave().jet(x, y); }
      };
      return Straight().castRay(ray);
    }
  };
  Random random(4);
  int wrong = 0;
  for (int i = 0; i < 100; ++i) {
    const Ray ray = {{-0.2, 0, random.uniform(-0.01, 0.01)}, Vector3::UnitX()};
    const auto right = Wave().castRay(ray);
    const auto hit = Careless().firstByNewton(ray);
    if (!hit || std::abs(hit->distance - right->distance) > 1e-6) ++wrong;
  }
  EXPECT_GT(wrong, 10);
}

TEST(HeightField, RefusesEmptyRectangles) {
  test::expectInputError([] { FlatPart({0, 0, 0, 1}); }, "height field: extent along x is 0.000000 m");
  test::expectInputError([] { Saddle(0.0, 0.1); }, "bending");
}

}  // namespace
}  // namespace scan_to_path::geometry
