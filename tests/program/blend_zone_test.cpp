// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/blend_zone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/random.h"

namespace scan_to_path::program {
namespace {

using geometry::Vector3;

TEST(BlendRadius, HandWorkedCorners) {
  const Vector3 a(-0.1, 0, 0), p(0, 0, 0);
  // A right angle: tolerance / sin 45 degrees.
  EXPECT_NEAR(blendRadius(a, p, {0, 0.1, 0}, 1e-3), 1e-3 * std::sqrt(2.0), 1e-15);
  // Straight on: half the way to the nearer neighbour.
  EXPECT_DOUBLE_EQ(blendRadius(a, p, {0.04, 0, 0}, 1e-6), 0.02);
  EXPECT_DOUBLE_EQ(blendRadius({-0.01, 0, 0}, p, {0.04, 0, 0}, 1e-6), 0.005);
  // Back the way it came: the tolerance itself.
  EXPECT_NEAR(blendRadius(a, p, a, 1e-3), 1e-3, 1e-15);
  // No way, no blend.
  EXPECT_EQ(blendRadius(p, p, {0.1, 0, 0}, 1e-3), 0.0);
  EXPECT_EQ(blendRadius(a, p, p, 1e-3), 0.0);
  EXPECT_EQ(blendRadius(a, p, {0, 0.1, 0}, 0.0), 0.0);
}

/// Largest distance of a parabola from q to r with control point p, ABB's corner path, from the lines q-p-r; and how
/// far it passes p.
std::pair<double, double> parabolaDeviation(const Vector3& q, const Vector3& p, const Vector3& r) {
  const auto toSegment = [](const Vector3& x, const Vector3& a, const Vector3& b) {
    const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (x - a - t * (b - a)).norm();
  };
  double off = 0.0;
  double corner = 1e9;
  for (int i = 0; i <= 200; ++i) {
    const double t = i / 200.0;
    const Vector3 x = (1 - t) * (1 - t) * q + 2 * t * (1 - t) * p + t * t * r;
    off = std::max(off, std::min(toSegment(x, q, p), toSegment(x, p, r)));
    corner = std::min(corner, (x - p).norm());
  }
  return {off, corner};
}

TEST(BlendRadius, AParabolaStaysWithinTheTolerance) {
  Random random(5);
  int limited = 0;
  for (int i = 0; i < 500; ++i) {
    const auto vector = [&] { return Vector3(random.gaussian(), random.gaussian(), random.gaussian()); };
    const Vector3 p = vector();
    const Vector3 in = random.uniform(1e-3, 0.1) * vector().normalized();
    const Vector3 out =
        random.uniform(1e-3, 0.1) * (in.normalized() + random.uniform(0.01, 2.0) * vector()).normalized();
    const double tolerance = random.uniform(1e-6, 1e-3);
    const double radius = blendRadius(p - in, p, p + out, tolerance);
    ASSERT_LE(radius, 0.5 * std::min(in.norm(), out.norm()) * (1 + 1e-12));
    const auto deviation = [&](double r) {
      return parabolaDeviation(p - r * in.normalized(), p, p + r * out.normalized());
    };
    EXPECT_LE(deviation(radius).first, tolerance * (1 + 1e-9));
    EXPECT_LE(deviation(radius).second, tolerance * (1 + 1e-9));
    // Twin: a parabola passes the corner at half of what the bound allows, so three times the radius is too much.
    if (radius < 0.499 * std::min(in.norm(), out.norm())) {
      ++limited;
      EXPECT_GT(deviation(3.0 * radius).second, tolerance);
    }
  }
  EXPECT_GT(limited, 100);
}

}  // namespace
}  // namespace scan_to_path::program
