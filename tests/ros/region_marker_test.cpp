// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/region_marker.h"

#include <gtest/gtest.h>

#include "support/flat_plate.h"

namespace scan_to_path_ros {
namespace {

using visualization_msgs::Marker;

TEST(RegionMarker, IsTheClosedPolygonOnThePart) {
  scan_to_path::pipeline::JobOptions options;
  options.cell.workpiece.xyz = {0.5, -0.2, 0.3};
  options.cell.workpiece.rpy = {0.0, 0.0, 0.5 * M_PI};
  options.path.region = {{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.05}};
  const auto T = scan_to_path::geometry::makeFrame(options.cell.workpiece.xyz, options.cell.workpiece.rpy);
  std_msgs::Header header;
  header.frame_id = "base_link";
  const Marker marker = regionMarker(options, scan_to_path::test::flatPlate(T), header);
  EXPECT_EQ(marker.header.frame_id, "base_link");
  EXPECT_EQ(marker.action, Marker::ADD);
  ASSERT_EQ(marker.points.size(), 4U);
  EXPECT_NEAR(marker.points[1].x, 0.5, 1e-12);
  EXPECT_NEAR(marker.points[1].y, -0.1, 1e-12);
  EXPECT_NEAR(marker.points[2].x, 0.45, 1e-12);
  EXPECT_EQ(marker.points[0].y, marker.points[3].y);
  for (const auto& point : marker.points) EXPECT_NEAR(point.z, 0.31, 1e-12);  // the plate's height
}

TEST(RegionMarker, OfNoRegionTakesTheLastOneAway) {
  const Marker marker = regionMarker({}, {}, {});
  EXPECT_EQ(marker.action, Marker::DELETE);
  EXPECT_TRUE(marker.points.empty());
}

}  // namespace
}  // namespace scan_to_path_ros
