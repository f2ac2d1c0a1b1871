// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/worlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/geometry/scene.h"
#include "support/expect_input_error.h"
#include "support/surface_oracle.h"

namespace scan_to_path::geometry {
namespace {

using test::expectInputError;
using test::marchedHit;

const double nowhere = std::nan("");

/// A world, and the same surface told in two other ways that share no code with it.
struct World {
  const char* name;
  std::shared_ptr<const AnalyticSurface> surface;
  std::function<double(const Vector3&)> implicit;     // negative inside, NaN outside of the domain
  std::function<Vector3(double, double)> parametric;  // from [0, 1]^2
  Vector3 centre;
  double size;       // [m]
  double curvature;  // largest magnitude [1/m]
};

std::function<double(const Vector3&)> overSquare(double low_x, double high_x, double low_y, double high_y,
                                                 std::function<double(double, double)> height) {
  return [=](const Vector3& p) {
    const bool is_inside = p.x() >= low_x && p.x() <= high_x && p.y() >= low_y && p.y() <= high_y;
    return is_inside ? p.z() - height(p.x(), p.y()) : nowhere;
  };
}

double sHeight(double x, double y) {
  return 0.020 * std::sin(2 * M_PI * (x - 0.12) / 0.24) + 0.004 * std::cos(M_PI * (y - 0.08) / 0.16) +
         0.003 * std::sin(2 * M_PI * x / 0.24) * std::sin(M_PI * y / 0.16);
}

Vector3 onCircle(double radius, double u) {
  return {radius * std::cos(2 * M_PI * u), radius * std::sin(2 * M_PI * u), 0.0};
}

std::vector<World> worlds() {
  return {
      {"Plane",
       std::make_shared<Plane>(),
       [](const Vector3& p) { return p.z(); },
       [](double u, double v) { return Vector3(u - 0.5, v - 0.5, 0.0); },
       {0, 0, 0},
       0.2,
       0.0},
      {"Sphere",
       std::make_shared<Sphere>(0.1),
       [](const Vector3& p) { return p.norm() - 0.1; },
       [](double u, double v) {
         return Vector3(std::sin(M_PI * v) * onCircle(0.1, u) + Vector3(0, 0, 0.1 * std::cos(M_PI * v)));
       },
       {0, 0, 0},
       0.1,
       10.0},
      {"Cylinder",
       std::make_shared<Cylinder>(0.05),
       [](const Vector3& p) { return std::hypot(p.x(), p.y()) - 0.05; },
       [](double u, double v) { return Vector3(onCircle(0.05, u) + Vector3(0, 0, v - 0.5)); },
       {0, 0, 0},
       0.1,
       20.0},
      {"Torus",
       std::make_shared<Torus>(0.1, 0.03),
       [](const Vector3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 0.1, p.z()) - 0.03; },
       [](double u, double v) {
         return Vector3(onCircle(0.1 + 0.03 * std::cos(2 * M_PI * v), u) +
                        Vector3(0, 0, 0.03 * std::sin(2 * M_PI * v)));
       },
       {0, 0, 0},
       0.13,
       1 / 0.03},
      {"FlatPart",
       std::make_shared<FlatPart>(Rectangle{-0.1, 0.1, -0.05, 0.05}),
       overSquare(-0.1, 0.1, -0.05, 0.05, [](double, double) { return 0.0; }),
       [](double u, double v) { return Vector3(0.2 * u - 0.1, 0.1 * v - 0.05, 0.0); },
       {0, 0, 0},
       0.1,
       0.0},
      {"Saddle",
       std::make_shared<Saddle>(0.2, 0.1),
       overSquare(-0.1, 0.1, -0.1, 0.1, [](double x, double y) { return x * y / 0.2; }),
       [](double u, double v) {
         return Vector3(0.2 * u - 0.1, 0.2 * v - 0.1, (0.2 * u - 0.1) * (0.2 * v - 0.1) / 0.2);
       },
       {0, 0, 0},
       0.1,
       5.0},
      {"SPart",
       std::make_shared<SPart>(),
       overSquare(0, 0.24, 0, 0.16, sHeight),
       [](double u, double v) { return Vector3(0.24 * u, 0.16 * v, sHeight(0.24 * u, 0.16 * v)); },
       {0.12, 0.08, 0.0},
       0.12,
       18.0},
  };
}

void PrintTo(const World& world, std::ostream* out) { *out << world.name; }

class AnalyticWorld : public ::testing::TestWithParam<World> {
protected:
  const World& world() const { return GetParam(); }

  Ray randomRay(Random& random) const {
    return test::randomRayTowards(random, world().centre, 5 * world().size, world().size);
  }

  Vector3 randomPointNear(Random& random, double reach) const {
    return world().centre + test::randomVector(random, reach);
  }

  Vector3 implicitGradient(const Vector3& p, double h) const {
    Vector3 gradient;
    for (int i = 0; i < 3; ++i) {
      gradient[i] = (world().implicit(p + h * Vector3::Unit(i)) - world().implicit(p - h * Vector3::Unit(i))) / (2 * h);
    }
    return gradient;
  }

  /// Random surface point away from the border, where central differences are possible.
  Vector3 innerPoint(Random& random) const {
    return world().parametric(random.uniform(0.05, 0.95), random.uniform(0.05, 0.95));
  }
};

TEST_P(AnalyticWorld, RayHitsWhereMarchingFindsTheFirstCrossing) {
  int hits = 0;
  int unseen_by_marching = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    for (int i = 0; i < 150; ++i) {
      const Ray ray = randomRay(random);
      const double step = world().size / 200;
      const double expected = marchedHit(world().implicit, ray, 10 * world().size, step);
      const auto hit = world().surface->castRay(ray, 10 * world().size);
      if (!hit) {
        EXPECT_TRUE(std::isnan(expected)) << "missed a hit at " << expected << ", seed " << seed << " ray " << i;
        continue;
      }
      ++hits;
      // The oracle bisects to rounding of the ray's points, 1e-16 m at this size, over a slope of at least 1e-3.
      if (std::abs(hit->distance - expected) < 1e-11) continue;
      // Marching passes two crossings within a step, and borders within a step of a crossing.
      ++unseen_by_marching;
      EXPECT_NEAR(world().implicit(hit->point + 1e-12 * (world().centre - hit->point)), 0.0, 1e-11);
    }
  }
  EXPECT_GT(hits, 150);
  EXPECT_LE(unseen_by_marching, hits / 50);
}

TEST_P(AnalyticWorld, HitLiesOnTheRayAndOnTheSurface) {
  Random random(11);
  for (int i = 0; i < 500; ++i) {
    const Ray ray = randomRay(random);
    const auto hit = world().surface->castRay(ray);
    if (!hit || hit->distance > 100 * world().size) continue;
    // Nine roundings of numbers the size of the distance, over the sine of a grazing angle.
    const double tolerance = 2e-15 * hit->distance / std::max(1e-6, std::abs(ray.direction.dot(hit->normal)));
    EXPECT_LT((ray.origin + hit->distance * ray.direction - hit->point).norm(), tolerance);
    EXPECT_LT((world().surface->closestPoint(hit->point).point - hit->point).norm(), 1e-13);
  }
}

TEST_P(AnalyticWorld, MaximumDistanceIsKept) {
  Random random(12);
  for (int i = 0; i < 200; ++i) {
    const Ray ray = randomRay(random);
    const auto hit = world().surface->castRay(ray);
    if (!hit) continue;
    EXPECT_FALSE(world().surface->castRay(ray, hit->distance * (1 - 1e-9)));
    EXPECT_TRUE(world().surface->castRay(ray, hit->distance * (1 + 1e-9)));
  }
}

TEST_P(AnalyticWorld, RayFromTheSurfaceDoesNotHitItsOwnOrigin) {
  Random random(13);
  for (int i = 0; i < 200; ++i) {
    const Vector3 on = innerPoint(random);
    const SurfacePoint closest = world().surface->closestPoint(on);
    const Ray away = {closest.point + 1e-9 * closest.normal, closest.normal};
    const auto hit = world().surface->castRay(away);
    if (hit) {
      EXPECT_GT(hit->distance, 1e-3 * world().size);
    }
  }
}

TEST_P(AnalyticWorld, NormalIsTheImplicitGradient) {
  Random random(14);
  for (int i = 0; i < 300; ++i) {
    const Vector3 p = innerPoint(random);
    const Vector3 expected = implicitGradient(p, 1e-5).normalized();
    // Central differences: rounding 1e-16 / 1e-5 plus third derivatives (below 1e4 / m^2) times h^2.
    EXPECT_LT(angleBetween(world().surface->closestPoint(p).normal, expected), 1e-6);
  }
}

TEST_P(AnalyticWorld, ClosestPointBeatsDenseSampling) {
  constexpr int samples = 400;
  std::vector<Vector3> cloud;
  for (int i = 0; i <= samples; ++i) {
    for (int j = 0; j <= samples; ++j) {
      cloud.push_back(world().parametric(static_cast<double>(i) / samples, static_cast<double>(j) / samples));
    }
  }
  double spacing = 0.0;
  for (std::size_t i = 0; i + samples + 2 < cloud.size(); i += 7) {
    if (i % (samples + 1) == samples) continue;
    spacing = std::max({spacing, (cloud[i] - cloud[i + 1]).norm(), (cloud[i] - cloud[i + samples + 1]).norm()});
  }
  Random random(15);
  for (int i = 0; i < 60; ++i) {
    // Some near, some far: there the nearest of several foot points is asked for.
    const Vector3 p = randomPointNear(random, i % 2 == 0 ? world().size : 3 * world().size);
    double sampled = std::numeric_limits<double>::infinity();
    for (const auto& q : cloud) sampled = std::min(sampled, (q - p).norm());
    const SurfacePoint closest = world().surface->closestPoint(p);
    const double distance = (closest.point - p).norm();
    EXPECT_LE(distance, sampled + 1e-12) << world().name << " point " << p.transpose();
    if (world().name == std::string("Plane") || world().name == std::string("Cylinder")) continue;  // without an end
    EXPECT_GE(distance, sampled - spacing);
  }
}

TEST_P(AnalyticWorld, CurvaturesAreTheChangeOfTheNormal) {
  Random random(16);
  constexpr double h = 1e-4;
  for (int i = 0; i < 200; ++i) {
    const Vector3 p = innerPoint(random);
    const PrincipalCurvatures k = world().surface->curvatures(p);
    const auto normalChange = [&](const Vector3& t) {
      return Vector3((implicitGradient(p + h * t, 1e-5).normalized() - implicitGradient(p - h * t, 1e-5).normalized()) /
                     (2 * h));
    };
    // Rounding of the gradients 1e-11 / h, and h^2 / 6 times derivatives up to k^3 of a few 1e4.
    const double tolerance = 3e-7 + 3e-4 * std::max(1.0, world().curvature * world().curvature) * 1e-2;
    EXPECT_NEAR(k.direction_min.dot(normalChange(k.direction_min)), k.k_min, tolerance);
    EXPECT_NEAR(k.direction_max.dot(normalChange(k.direction_max)), k.k_max, tolerance);
    EXPECT_NEAR(k.direction_min.dot(normalChange(k.direction_max)), 0.0, tolerance);
    EXPECT_LE(k.k_min, k.k_max);
    const Vector3 n = world().surface->closestPoint(p).normal;
    EXPECT_NEAR(std::abs(k.direction_min.cross(k.direction_max).dot(n)), 1.0, 1e-12);
  }
}

TEST_P(AnalyticWorld, SignedDistanceIsTheHeightOverTheSurface) {
  Random random(17);
  for (int i = 0; i < 200; ++i) {
    const SurfacePoint on = world().surface->closestPoint(innerPoint(random));
    const double height = random.uniform(-0.01, 0.01);
    const Vector3 p = on.point + height * on.normal;
    if (std::abs(world().implicit(p)) > 0.02 || std::isnan(world().implicit(p))) continue;
    EXPECT_NEAR(signedDistance(*world().surface, p), height, 1e-14);
  }
}

TEST_P(AnalyticWorld, AnswersMoveWithTheSurface) {
  Random random(18);
  for (int i = 0; i < 200; ++i) {
    const Frame T = test::randomFrame(random);
    const PosedSurface moved(world().surface, T);
    const Ray ray = randomRay(random);
    const auto expected = world().surface->castRay(ray);
    const auto hit = moved.castRay({T * ray.origin, T.linear() * ray.direction});
    if (expected && std::abs(expected->normal.dot(ray.direction)) < 1e-3) continue;  // grazing: rounding decides
    ASSERT_EQ(hit.has_value(), expected.has_value());
    if (hit && expected->distance < 100 * world().size) {
      // Rounding of the motion, 1e-15 m, over the sine of the angle.
      EXPECT_NEAR(hit->distance, expected->distance, 3e-12);
      EXPECT_LT((hit->point - T * expected->point).norm(), 3e-12);
      EXPECT_LT((hit->normal - T.linear() * expected->normal).norm(), 1e-10);
    }
    const Vector3 p = innerPoint(random) + test::randomVector(random, 0.005);
    EXPECT_LT((moved.closestPoint(T * p).point - T * world().surface->closestPoint(p).point).norm(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, AnalyticWorld, ::testing::ValuesIn(worlds()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Worlds, RayAlongTheTangentPasses) {
  EXPECT_FALSE(Plane().castRay({{0, 0, 0.1}, {1, 0, 0}}));
  EXPECT_FALSE(Plane().castRay({{0, 0, 0.0}, {1, 0, 0}}));
  EXPECT_FALSE(Cylinder(0.1).castRay({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_FALSE(Sphere(0.1).castRay({{0, 0.2, 0}, {1, 0, 0}}));
  EXPECT_FALSE(Torus(0.1, 0.03).castRay({{0, 0, -1}, {0, 0, 1}}));  // through the hole
}

TEST(Worlds, RaysFromInsideSeeTheFarWall) {
  EXPECT_DOUBLE_EQ(Sphere(0.1).castRay({{0, 0, 0}, {1, 0, 0}})->distance, 0.1);
  EXPECT_DOUBLE_EQ(Cylinder(0.1).castRay({{0.05, 0, 7}, {1, 0, 0}})->distance, 0.05);
  EXPECT_NEAR(Torus(0.1, 0.03).castRay({{0.1, 0, 0}, {1, 0, 0}})->distance, 0.03, 1e-15);
}

TEST(Worlds, TorusHitFromAfarKeepsItsDigits) {
  // One rounding of the distance itself is 1.2e-10 m at 1e6 m.
  EXPECT_NEAR(Torus(0.1, 0.03).castRay({{-1e6, 0, 0}, {1, 0, 0}})->distance, 1e6 - 0.13, 3e-10);
}

TEST(Worlds, CentresHaveSomeClosestPoint) {
  EXPECT_DOUBLE_EQ(Sphere(0.1).closestPoint({0, 0, 0}).point.norm(), 0.1);
  EXPECT_DOUBLE_EQ(Cylinder(0.1).closestPoint({0, 0, 3}).point.norm(), std::hypot(0.1, 3));
  EXPECT_TRUE(Torus(0.1, 0.03).closestPoint({0, 0, 0}).point.allFinite());
}

TEST(Worlds, RefuseImpossibleSizes) {
  expectInputError([] { Sphere(0.0); }, "sphere: radius is");
  expectInputError([] { Cylinder(-1.0); }, "cylinder: radius is");
  expectInputError([] { Sphere(std::nan("")); }, "must be positive and finite");
  expectInputError([] { Torus(0.1, 0.1); }, "torus: minor radius is 0.100000 m, must be below");
}

}  // namespace
}  // namespace scan_to_path::geometry
