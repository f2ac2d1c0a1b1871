// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/path_place.h"

#include <gmock/gmock.h>

#include "scan_to_path/pipeline/summary.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(PathPlace, StandsInTheSummary) {
  toolpath::ToolPath path;
  path.frame = "base_link";
  path.segments = {{"row_0", std::vector<toolpath::Waypoint>(4)}};
  auto& waypoints = path.segments[0].waypoints;
  waypoints[0].pose.translation() = geometry::Vector3(5.0, 5.0, 5.0);  // in the air
  waypoints[1].pose.translation() = geometry::Vector3(0.9, 0.1, 0.5);
  waypoints[2].pose.translation() = geometry::Vector3(1.1, -0.1, 0.52);
  waypoints[3].pose.translation() = geometry::Vector3(5.0, 5.0, 5.0);
  waypoints[2].process_on = true;  // on the move from the one before
  Report report;
  EXPECT_THAT(summarise(report, path, {}), Not(Contains(HasSubstr("work object"))));
  // The work object's x is the base's y.
  report.place = placeOf(path, geometry::makeFrame({0.9, 0.0, 0.5}, {0.0, 0.0, M_PI / 2.0}));
  EXPECT_THAT(summarise(report, path, {}),
              Contains("place     x 0.900 to 1.100, y -0.100 to 0.100, z 0.500 to 0.520 m in base_link, "
                       "x -0.100 to 0.100, y -0.200 to 0.000, z 0.000 to 0.020 m in the work object"));
  EXPECT_TRUE(placeOf({}, geometry::Frame::Identity()).isEmpty());
}

}  // namespace
}  // namespace scan_to_path::pipeline
