// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/obstacles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scan_to_path/common/random.h"

namespace scan_to_path::scan {
namespace {

Obstacles somePoints() {
  Random random(7);
  Obstacles points;
  for (int i = 0; i < 5000; ++i) {
    points.emplace_back(static_cast<float>(0.02 * random.uniform() - 0.01), static_cast<float>(0.01 * random.uniform()),
                        static_cast<float>(0.005 * random.gaussian()));
  }
  return points;
}

TEST(Obstacles, OfEachSquareTheHighestPointIsKept) {
  const Obstacles points = somePoints();
  std::map<std::pair<int, int>, float> highest;
  for (const auto& p : points) {
    const std::pair key(static_cast<int>(std::floor(p.x() / 0.001)), static_cast<int>(std::floor(p.y() / 0.001)));
    const auto entry = highest.emplace(key, p.z()).first;
    entry->second = std::max(entry->second, p.z());
  }
  const Obstacles kept = highestPoints(points, 0.001);
  ASSERT_EQ(kept.size(), highest.size());
  for (const auto& p : kept) {
    EXPECT_EQ(p.z(),
              highest.at({static_cast<int>(std::floor(p.x() / 0.001)), static_cast<int>(std::floor(p.y() / 0.001))}));
  }
}

TEST(Obstacles, TheirOrderDoesNotMatter) {
  Obstacles points = somePoints();
  const Obstacles kept = highestPoints(points, 0.001);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(highestPoints(points, 0.001), kept);
  EXPECT_EQ(highestPoints(kept, 0.001), kept);
}

}  // namespace
}  // namespace scan_to_path::scan
