// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/outline_clip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::toolpath {
namespace {

using Eigen::Vector2d;
using Polygon = std::vector<Vector2d>;

const Polygon square = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
const Polygon hole = {{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}};

double distanceToEdge(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - share * (b - a)).norm();
}

/// Inside by the winding of angles, and farther than the margin from every edge: the oracle.
bool isAllowed(const scan::Outline& outline, const Vector2d& p, double margin) {
  double turn = 0.0;
  for (const auto& polygon : outline.polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2d& a = polygon[i];
      const Vector2d& b = polygon[(i + 1) % polygon.size()];
      if (distanceToEdge(p, a, b) <= margin) return false;
      const Vector2d u = a - p, v = b - p;
      turn += std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    }
  }
  return std::abs(turn) > 3.0;
}

TEST(OutlineClip, CutsASquareWithAHole) {
  const OutlineClip clip({{square, hole}}, 0.0, 0.0);
  EXPECT_EQ(clip.first(), 0.0);
  EXPECT_EQ(clip.last(), 1.0);
  ASSERT_EQ(clip.inside(0.2).size(), 1U);
  const auto split = clip.inside(0.5);
  ASSERT_EQ(split.size(), 2U);
  EXPECT_NEAR(split[0].begin, 0.0, 1e-15);
  EXPECT_NEAR(split[0].end, 0.4, 1e-15);
  EXPECT_NEAR(split[1].begin, 0.6, 1e-15);
  EXPECT_NEAR(split[1].end, 1.0, 1e-15);
  EXPECT_TRUE(clip.inside(1.5).empty());
}

TEST(OutlineClip, KeepsTheMarginFromEveryEdge) {
  const OutlineClip clip({{square, hole}}, 0.0, 0.05);
  EXPECT_TRUE(clip.inside(0.04).empty());
  const auto below_hole = clip.inside(0.37);  // 0.03 below the hole's edge: the corners cut discs
  ASSERT_EQ(below_hole.size(), 2U);
  EXPECT_NEAR(below_hole[0].begin, 0.05, 1e-15);
  EXPECT_NEAR(below_hole[0].end, 0.4 - std::sqrt(0.05 * 0.05 - 0.03 * 0.03), 1e-15);
}

TEST(OutlineClip, AgreesWithTheDefinitionPointByPoint) {
  Random random(4);
  for (int round = 0; round < 40; ++round) {
    Polygon star;  // star-shaped, hollow corners included
    for (int i = 0; i < 17; ++i) {
      const double angle = 2.0 * M_PI * i / 17.0;
      star.push_back(random.uniform(0.3, 1.0) * Vector2d(std::cos(angle), std::sin(angle)));
    }
    const scan::Outline outline = {{star, {{0.1, 0.0}, {0.0, -0.1}, {-0.1, 0.05}}}};
    const double direction = random.uniform(-4.0, 4.0);
    const double margin = round % 2 == 0 ? 0.0 : random.uniform(0.0, 0.1);
    const OutlineClip clip(outline, direction, margin);
    const Vector2d along(std::cos(direction), std::sin(direction));
    const Vector2d across(-along.y(), along.x());
    for (int i = 0; i < 20; ++i) {
      const double s = random.uniform(-1.0, 1.0);
      const auto intervals = clip.inside(s);
      for (int k = 0; k < 40; ++k) {
        const double t = random.uniform(-1.0, 1.0);
        bool is_inside = false;
        for (const auto& interval : intervals) is_inside |= t > interval.begin && t < interval.end;
        EXPECT_EQ(is_inside, isAllowed(outline, t * along + s * across, margin)) << round << " " << t << " " << s;
      }
    }
  }
}

TEST(OutlineClip, RejectsOutlinesThatBoundNothing) {
  test::expectInputError([] { OutlineClip({}, 0.0, 0.0); }, "no polygon");
  test::expectInputError([] { OutlineClip({{{{0, 0}, {1, 1}}}}, 0.0, 0.0); }, "fewer than three points");
  test::expectInputError([] { OutlineClip({{{{0, 0}, {1, std::nan("")}, {1, 0}}}}, 0.0, 0.0); }, "not finite");
}

}  // namespace
}  // namespace scan_to_path::toolpath
