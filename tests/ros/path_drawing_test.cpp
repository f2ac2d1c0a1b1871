// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/path_drawing.h"

#include <gmock/gmock.h>

#include "scan_to_path/common/error.h"
#include "support/paths.h"

namespace scan_to_path_ros {
namespace {

using core::geometry::Vector3;
using core::toolpath::Verdict;
using core::toolpath::WaypointVerdict;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double rounding = 1e-12;  // sums of a few numbers below 1 m

/// Two rows, 0.1 m long, to and fro 0.01 m apart, in ten moves each, and a link between them.
core::toolpath::ToolPath twoRows() {
  auto path = core::test::planeRows(2, 0.01, 0.1, 10, true);
  core::toolpath::Segment link = {"link_0_1", {path.segments[0].waypoints.back(), path.segments[1].waypoints.front()}};
  for (auto& waypoint : link.waypoints) waypoint.process_on = false;
  path.segments.insert(path.segments.begin() + 1, link);
  return path;
}

WaypointVerdict verdict(int segment, int index, Verdict found) {
  WaypointVerdict entry;
  entry.segment = segment;
  entry.index = index;
  entry.verdict = found;
  return entry;
}

PathDrawingOptions linesOnly() {
  PathDrawingOptions options;
  options.arrow_interval = 0.0;
  return options;
}

TEST(PathDrawing, drawsEveryMoveOnce) {
  const auto path = twoRows();
  const auto drawing = drawPath(path, {}, linesOnly());
  ASSERT_THAT(drawing.strips, SizeIs(3));
  EXPECT_THAT(drawing.strips[0].points, SizeIs(11));
  EXPECT_TRUE(drawing.strips[0].process_on);
  EXPECT_THAT(drawing.strips[1].points, SizeIs(2));
  EXPECT_FALSE(drawing.strips[1].process_on);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(drawing.strips[2].points[i], Vector3(path.segments[2].waypoints[i].pose.translation()));
  }
  EXPECT_NEAR(drawing.length_on, 0.2, rounding);
  EXPECT_NEAR(drawing.length_off, 0.01, rounding);
  EXPECT_EQ(describePath(drawing), "2 rows, 3 segments, 24 waypoints; 0.20 m on, 0.01 m off");
  EXPECT_EQ(describeVerdicts(drawing), "24 ok");
}

TEST(PathDrawing, breaksStripsWhereTheProcessChanges) {
  auto path = twoRows();
  path.segments[0].waypoints[4].process_on = false;
  const auto drawing = drawPath(path, {}, linesOnly());
  ASSERT_THAT(drawing.strips, SizeIs(5));
  EXPECT_THAT(drawing.strips[0].points, SizeIs(4));
  EXPECT_THAT(drawing.strips[1].points, SizeIs(2));
  EXPECT_FALSE(drawing.strips[1].process_on);
  EXPECT_EQ(drawing.strips[1].points.front(), drawing.strips[0].points.back());
  EXPECT_EQ(drawing.strips[2].points.front(), drawing.strips[1].points.back());
}

TEST(PathDrawing, breaksStripsThatAreTooLong) {
  auto options = linesOnly();
  options.strip_points = 4;
  const auto drawing = drawPath(core::test::planeRows(1, 0.01, 0.1, 10), {}, options);
  // Ten moves, three to a strip.
  ASSERT_THAT(drawing.strips, SizeIs(4));
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(drawing.strips[i].points.front(), drawing.strips[i - 1].points.back());
  EXPECT_THAT(drawing.strips.back().points, SizeIs(2));
  options.strip_points = 1;
  EXPECT_THROW(drawPath(twoRows(), {}, options), core::InputError);
}

TEST(PathDrawing, showsBadWaypoints) {
  const auto drawing = drawPath(twoRows(), {verdict(0, 0, Verdict::jump), verdict(2, 5, Verdict::gouge)}, linesOnly());
  // The first row's first move comes from the bad waypoint; the moves to and from the other one are bad.
  ASSERT_THAT(drawing.strips, SizeIs(6));
  EXPECT_EQ(drawing.strips[0].verdict, Verdict::jump);
  EXPECT_THAT(drawing.strips[0].points, SizeIs(2));
  EXPECT_EQ(drawing.strips[4].verdict, Verdict::gouge);
  EXPECT_THAT(drawing.strips[4].points, SizeIs(3));
  ASSERT_THAT(drawing.marks, SizeIs(2));
  EXPECT_LT((drawing.marks[1].point - Vector3(0.05, 0.01, 0.0)).norm(), rounding);
  EXPECT_EQ(drawing.marks[1].verdict, Verdict::gouge);
  EXPECT_EQ(describeVerdicts(drawing), "22 ok, 1 gouge, 1 jump");
}

TEST(PathDrawing, refusesVerdictsOfAnotherPath) {
  for (const auto& entry : {verdict(3, 0, Verdict::ok), verdict(0, 11, Verdict::ok), verdict(-1, 0, Verdict::ok),
                            verdict(0, -1, Verdict::ok)}) {
    EXPECT_THROW(drawPath(twoRows(), {entry}, linesOnly()), core::InputError);
  }
}

TEST(PathDrawing, arrowsPointWhereTheToolGoes) {
  PathDrawingOptions options;
  options.arrow_interval = 0.04;
  options.arrow_size = 0.012;
  const auto drawing = drawPath(twoRows(), {}, options);
  // 0.1 m take two, 0.025 m and 0.075 m on the way; the link is shorter than an arrow.
  ASSERT_THAT(drawing.arrows, SizeIs(4));
  EXPECT_LT((drawing.arrows[0][1] - Vector3(0.025 + 0.006, 0.0, 0.0)).norm(), rounding);
  EXPECT_LT((0.5 * (drawing.arrows[0][0] + drawing.arrows[0][2]) - Vector3(0.025 - 0.006, 0.0, 0.0)).norm(), rounding);
  EXPECT_NEAR((drawing.arrows[0][0] - drawing.arrows[0][2]).norm(), 0.7 * 0.012, rounding);
  // The second row goes back.
  EXPECT_LT((drawing.arrows[2][1] - Vector3(0.075 - 0.006, 0.01, 0.0)).norm(), rounding);
  EXPECT_NEAR(drawing.arrows[2][0].z(), 0.0, rounding);
}

TEST(PathDrawing, arrowsOfAPlungeHaveWidth) {
  auto path = core::test::planeRows(1, 0.01, 0.1, 1);
  path.segments[0].name = "approach";
  path.segments[0].waypoints[0].pose = path.segments[0].waypoints[1].pose;
  path.segments[0].waypoints[0].pose.translation().z() += 0.05;
  PathDrawingOptions options;
  const auto drawing = drawPath(path, {}, options);
  ASSERT_THAT(drawing.arrows, SizeIs(1));
  EXPECT_NEAR((drawing.arrows[0][0] - drawing.arrows[0][2]).norm(), 0.7 * options.arrow_size, rounding);
  EXPECT_NEAR(drawing.arrows[0][1].z(), 0.025 - 0.5 * options.arrow_size, rounding);
}

TEST(PathDrawing, framesStandAtIntervals) {
  auto options = linesOnly();
  options.frame_interval = 0.024;
  const auto path = core::test::planeRows(1, 0.01, 0.1, 10);
  // Waypoints are 0.01 m apart: the first one past 0, 0.024, 0.048, 0.072 and 0.096 m.
  const auto drawing = drawPath(path, {}, options);
  std::vector<double> x;
  for (const auto& frame : drawing.frames) x.push_back(frame.translation().x());
  EXPECT_THAT(x, ElementsAre(DoubleNear(0.0, rounding), DoubleNear(0.03, rounding), DoubleNear(0.05, rounding),
                             DoubleNear(0.08, rounding), DoubleNear(0.1, rounding)));
  EXPECT_TRUE(drawing.frames[1].isApprox(path.segments[0].waypoints[3].pose));
}

TEST(PathDrawing, drawsTheRowsAskedFor) {
  auto options = linesOnly();
  options.rows = core::toolpath::RowSelection::parse("1", "rows");
  options.links = false;
  auto drawing = drawPath(twoRows(), {verdict(0, 3, Verdict::gouge)}, options);
  ASSERT_THAT(drawing.strips, SizeIs(1));
  EXPECT_NEAR(drawing.strips[0].points[0].y(), 0.01, rounding);
  EXPECT_THAT(drawing.marks, IsEmpty());
  EXPECT_EQ(drawing.rows, 2U);
  EXPECT_EQ(drawing.rows_shown, 1U);
  // The figures are the path's.
  EXPECT_EQ(describeVerdicts(drawing), "23 ok, 1 gouge");
  options.links = true;
  EXPECT_THAT(drawPath(twoRows(), {}, options).strips, SizeIs(2));
}

TEST(PathDrawing, emptyPathsAndLoneWaypointsAreDrawn) {
  PathDrawingOptions options;
  options.frame_interval = 0.01;
  EXPECT_EQ(describePath(drawPath({}, {}, options)), "0 rows, 0 segments, 0 waypoints; 0.00 m on, 0.00 m off");
  core::toolpath::ToolPath path;
  path.segments = {{"row_0", {}}, {"row_1", {core::toolpath::Waypoint()}}};
  const auto drawing = drawPath(path, {verdict(1, 0, Verdict::collision)}, options);
  EXPECT_THAT(drawing.strips, IsEmpty());
  EXPECT_THAT(drawing.arrows, IsEmpty());
  EXPECT_THAT(drawing.marks, SizeIs(1));
  EXPECT_THAT(drawing.frames, SizeIs(1));
}

}  // namespace
}  // namespace scan_to_path_ros
