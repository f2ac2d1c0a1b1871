// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/laser_spot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/geometry/worlds.h"

namespace scan_to_path::sensing {
namespace {

using geometry::Frame;
using geometry::Vector3;

constexpr double diameter = 50e-6;

/// Looking down from (x, y, 0.08).
Frame lookingDown(double x, double y) { return geometry::makeFrame({x, y, 0.08}, {M_PI, 0.0, 0.0}); }

/// A plate at z = 0 for x >= 0, and one 5 mm lower for x < 0, or nothing there.
geometry::Scene step(bool with_floor) {
  std::vector<std::shared_ptr<const geometry::Surface>> surfaces = {
      std::make_shared<geometry::FlatPart>(geometry::Rectangle{0.0, 0.1, -0.1, 0.1})};
  const auto floor = std::make_shared<geometry::FlatPart>(geometry::Rectangle{-0.1, 0.0, -0.1, 0.1});
  if (with_floor) {
    surfaces.push_back(
        std::make_shared<geometry::PosedSurface>(floor, geometry::makeFrame({0, 0, -0.005}, Vector3::Zero())));
  }
  return geometry::Scene(surfaces);
}

TEST(LaserSpot, SmoothSurfacesReadAsOnTheAxis) {
  const LaserSpot spot(diameter, {});
  const geometry::SPart part;
  for (double x = 0.001; x < 0.24; x += 0.0037) {
    const auto reading = spot.read(part, lookingDown(x, 0.1));
    ASSERT_TRUE(reading.distance && reading.on_axis);
    EXPECT_EQ(*reading.distance, *reading.on_axis);
    EXPECT_NEAR(*reading.distance, 0.08 - part.jet(x, 0.1).z, 1e-12);
  }
}

TEST(LaserSpot, StepsMixBothSidesOverTheSpot) {
  const LaserSpot spot(diameter, {});
  const geometry::Scene scene = step(true);
  double before = 0.085;
  for (double x = -40e-6; x <= 40e-6; x += 1e-6) {
    const double distance = spot.read(scene, lookingDown(x, 0.0)).distance.value();
    EXPECT_LE(distance, before + 1e-15);  // ever more of the upper side
    before = distance;
    if (std::abs(x) < 0.5 * diameter) continue;
    EXPECT_DOUBLE_EQ(distance, x < 0.0 ? 0.085 : 0.080);
  }
  // Of a Gaussian spot cut at its 1/e^2 radius, 0.8731 lies on the larger side of a chord at half the radius (by
  // quadrature). 64 even points miss shares of half planes by up to 64^-3/4 = 0.044 (Beck and Chen 1987).
  const double quarter = spot.read(scene, lookingDown(0.25 * diameter, 0.0)).distance.value();
  EXPECT_NEAR((0.085 - quarter) / 0.005, 0.8731, 0.044);
  const double middle = spot.read(scene, lookingDown(1e-9, 0.0)).distance.value();
  EXPECT_NEAR((0.085 - middle) / 0.005, 0.5, 0.044);
}

TEST(LaserSpot, WithoutASpotEdgesAreSharp) {
  const LaserSpot ray(0.0, {});
  const geometry::Scene scene = step(true);
  EXPECT_DOUBLE_EQ(ray.read(scene, lookingDown(1e-9, 0.0)).distance.value(), 0.080);
  EXPECT_DOUBLE_EQ(ray.read(scene, lookingDown(-1e-9, 0.0)).distance.value(), 0.085);
}

TEST(LaserSpot, HalfTheLightIsNeeded) {
  const LaserSpot spot(diameter, {});
  const geometry::Scene scene = step(false);
  EXPECT_DOUBLE_EQ(spot.read(scene, lookingDown(10e-6, 0.0)).distance.value(), 0.080);
  EXPECT_FALSE(spot.read(scene, lookingDown(-10e-6, 0.0)).distance);
  EXPECT_FALSE(spot.read(scene, lookingDown(-1.0, 0.0)).on_axis);
}

TEST(LaserSpot, OutOfRangeIsSeenOnTheAxisButNotRead) {
  PointLaserOptions laser;
  laser.distance_min = 0.081;
  const auto near = LaserSpot(diameter, laser).read(geometry::Plane(), lookingDown(0.0, 0.0));
  EXPECT_FALSE(near.distance);
  EXPECT_NEAR(near.on_axis.value(), 0.08, 1e-12);
  laser = {};
  laser.distance_max = 0.079;
  const auto far = LaserSpot(0.0, laser).read(geometry::Plane(), lookingDown(0.0, 0.0));
  EXPECT_FALSE(far.distance);
  EXPECT_NEAR(far.on_axis.value(), 0.08, 1e-12);
}

}  // namespace
}  // namespace scan_to_path::sensing
