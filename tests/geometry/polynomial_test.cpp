// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../../src/geometry/polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scan_to_path/common/random.h"

namespace scan_to_path::geometry {
namespace {

Polynomial fromRoots(const std::vector<double>& roots) {
  Polynomial p = {1.0};
  for (const double root : roots) {
    Polynomial next(p.size() + 1, 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
      next[i + 1] += p[i];
      next[i] -= root * p[i];
    }
    p = next;
  }
  return p;
}

TEST(Polynomial, FindsTheRootsItWasMadeOf) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> roots(1 + i % 4);
    for (auto& root : roots) root = random.uniform(-1, 1);
    std::sort(roots.begin(), roots.end());
    double gap = 1.0;
    for (std::size_t k = 1; k < roots.size(); ++k) gap = std::min(gap, roots[k] - roots[k - 1]);
    if (gap < 0.05) continue;
    const auto found = realRoots(fromRoots(roots), -2, 2);
    ASSERT_EQ(found.size(), roots.size());
    // Coefficients are at most 6 with a few roundings each; the slope at a root is at least gap^3.
    for (std::size_t k = 0; k < roots.size(); ++k) EXPECT_NEAR(found[k], roots[k], 6e-15 / (gap * gap * gap));
  }
}

TEST(Polynomial, KeepsToTheInterval) {
  const Polynomial p = fromRoots({-1, 0.5, 3});
  EXPECT_EQ(realRoots(p, 0, 2).size(), 1U);
  EXPECT_TRUE(realRoots(p, 1, 2).empty());
  EXPECT_TRUE(realRoots(p, 2, 1).empty());
}

TEST(Polynomial, HasNoRootsWhereThereAreNone) {
  EXPECT_TRUE(realRoots({1, 0, 1}, -10, 10).empty());
  EXPECT_TRUE(realRoots({5}, -10, 10).empty());
  EXPECT_TRUE(realRoots({2, 0, 0, 0, 1}, -10, 10).empty());
}

}  // namespace
}  // namespace scan_to_path::geometry
