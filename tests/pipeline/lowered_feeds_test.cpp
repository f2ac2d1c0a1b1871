// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/lowered_feeds.h"

#include <gmock/gmock.h>

namespace scan_to_path::pipeline {
namespace {

toolpath::ToolPath twoRows() {
  toolpath::ToolPath path;
  for (const double feed : {0.02, 0.04}) {
    path.segments.push_back({"row_" + std::to_string(path.segments.size()), {}});
    for (int i = 0; i < 3; ++i)
      path.segments.back().waypoints.push_back({geometry::Frame::Identity(), feed, true, 0.0});
  }
  return path;
}

TEST(LoweredFeeds, NoneIsAFigureAndNoNote) {
  const LoweredFeeds found = loweredFeeds(twoRows(), {0.02, 0.02, 0.02, 0.04, 0.04, 0.04});
  ASSERT_EQ(found.accuracy.size(), 1U);
  EXPECT_EQ(found.accuracy[0].name, "feed_lowered");
  EXPECT_EQ(found.accuracy[0].value, 0.0);
  EXPECT_FALSE(found.note);
}

TEST(LoweredFeeds, CountsThemAndNamesTheLeast) {
  const LoweredFeeds found = loweredFeeds(twoRows(), {0.02, 0.015, 0.02, 0.04, 0.012, 0.03});
  ASSERT_EQ(found.accuracy.size(), 2U);
  EXPECT_EQ(found.accuracy[0].value, 3.0);
  EXPECT_EQ(found.accuracy[1].name, "feed_least");
  EXPECT_EQ(found.accuracy[1].value, 0.012);
  EXPECT_EQ(found.accuracy[1].unit, "m/s");
  EXPECT_EQ(found.note,
            "feed lowered at 3 of 6 waypoints, where a joint would be too fast: to 0.012000 m/s at row_1 waypoint 1, "
            "where 0.040000 m/s is asked for; motion.least_feed_share=1 lets them fail instead");
}

TEST(LoweredFeeds, AnEmptyPathHasNone) { EXPECT_FALSE(loweredFeeds({}, {}).note); }

}  // namespace
}  // namespace scan_to_path::pipeline
