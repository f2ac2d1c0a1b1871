// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/tool_path.h"

#include <gtest/gtest.h>

#include "support/expect_input_error.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

namespace scan_to_path::toolpath {
namespace {

using test::expectInputError;

ToolPath randomPath(std::uint64_t seed) {
  Random random(seed);
  ToolPath path = test::planeRows(3, 0.004, 0.1, 4);
  path.T_contact_tcp = test::randomFrame(random);
  for (auto& segment : path.segments) {
    for (auto& waypoint : segment.waypoints) {
      waypoint.pose = test::randomFrame(random);
      waypoint.feed = random.uniform(0.0, 1.0);
    }
  }
  return withArcLength(path);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(ToolPath, IsTheSameAfterWritingAndReading) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    ToolPath path = randomPath(seed);
    for (auto& segment : path.segments) {
      for (auto& waypoint : segment.waypoints) waypoint.feed = std::round(1e6 * waypoint.feed) / 1e6;
    }
    const ToolPath again = parseToolPath(formatToolPath(path), "path.csv");
    EXPECT_EQ(again.frame, "base_link");
    // Half of the last digit written: 5e-10 m; the quaternion's 5e-13 turn a matrix by less.
    EXPECT_LT(test::largestDifference(path, again), 6e-10);
    EXPECT_NEAR(again.segments[1].waypoints[4].arc_length, path.segments[1].waypoints[4].arc_length, 1e-8);
  }
}

TEST(ToolPath, IsWrittenAsDocumented) {
  ToolPath path = test::planeRows(1, 0.0, 0.5, 1);
  EXPECT_EQ(formatToolPath(path),
            "# scan_to_path path 1\n"
            "# process cutting\n"
            "# frame base_link\n"
            "# T_contact_tcp 0.000000000 0.000000000 0.000000000 1.000000000000 0.000000000000 0.000000000000 "
            "0.000000000000\n"
            "segment,index,x,y,z,qx,qy,qz,qw,feed,process_on\n"
            "row_0,0,0.000000000,0.000000000,0.000000000,0.000000000000,0.000000000000,0.000000000000,1.000000000000,"
            "0.020000,0\n"
            "row_0,1,0.500000000,0.000000000,0.000000000,0.000000000000,0.000000000000,0.000000000000,1.000000000000,"
            "0.020000,1\n");
}

TEST(ToolPath, MeasuresArcLengthFromEachSegmentsStart) {
  const ToolPath path = test::planeRows(2, 0.004, 0.1, 4);
  EXPECT_EQ(waypointCount(path), 10U);
  for (const auto& segment : path.segments) {
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_NEAR(segment.waypoints[i].arc_length, 0.025 * static_cast<double>(i), 1e-15);
  }
}

TEST(ToolPath, TellsNeighbouringSegmentsOfOneNameApart) {
  ToolPath path = test::planeRows(2, 0.004, 0.1, 1);
  path.segments[1].name = path.segments[0].name;
  EXPECT_EQ(parseToolPath(formatToolPath(path), "p").segments.size(), 2U);
}

TEST(ToolPath, ReadsWindowsLineEnds) {
  const ToolPath path = test::planeRows(1, 0.0, 0.5, 1);
  std::string text;
  for (const char c : formatToolPath(path)) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(waypointCount(parseToolPath(text, "p")), 2U);
}

TEST(ToolPath, RejectsFilesThatAreNoPath) {
  const std::string good = formatToolPath(test::planeRows(2, 0.004, 0.1, 1));
  const auto rejects = [](const std::string& text, const std::string& part) {
    expectInputError([&] { parseToolPath(text, "path.csv"); }, part);
  };
  rejects("", "path.csv: ends after line 0");
  rejects("x\n", "path.csv line 1: must be \"# scan_to_path path 1\"");
  rejects("# scan_to_path path 1\n", "ends after line 1");
  rejects(replaced(good, "# process cutting\n", ""), "no comment \"# process");
  rejects(replaced(good, "# frame base_link\n", ""), "no comment \"# frame");
  rejects(replaced(good, "# T_contact_tcp 0.000000000", "# T_contact_tcp"), "seven numbers");
  rejects(replaced(good, "row_0,0,0.000000000", "row_0,0,nan"), "path.csv line 6: x is \"nan\"");
  rejects(replaced(good, "row_0,1", "row_0,2"), "path.csv line 7: index is 2, must count up from 0");
  rejects(replaced(good, "row_1,0", "row_1,1"), "line 8");
  rejects(replaced(good, "0.020000,1", "0.020000,yes"), "process_on is \"yes\"");
  rejects(replaced(good, "0.020000,1", "-0.020000,1"), "feed is -0.020000 m/s");
  rejects(replaced(good, "1.000000000000,0.02", "0.900000000000,0.02"), "quaternion's length must be 1");
  rejects(replaced(good, ",0.020000,0\n", "\n"), "has 9 cells, must have 11");
  rejects(replaced(good, "row_0,0", " ,0"), "no name");
}

TEST(ToolPath, RejectsPathsThatCannotBeWritten) {
  ToolPath path = test::planeRows(1, 0.0, 0.1, 1);
  path.segments[0].name = "row,0";
  expectInputError([&] { formatToolPath(path); }, "segment \"row,0\"");
  path.segments[0].name = "row_0";
  path.segments[0].waypoints[1].pose.translation().x() = std::nan("");
  expectInputError([&] { formatToolPath(path); }, "row_0 waypoint 1 is not finite");
  path.segments[0].waypoints.clear();
  expectInputError([&] { formatToolPath(path); }, "has no waypoints");
}

}  // namespace
}  // namespace scan_to_path::toolpath
