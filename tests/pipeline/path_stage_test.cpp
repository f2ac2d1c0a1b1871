// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/path_stage.h"

#include <gmock/gmock.h>

#include "scan_to_path/toolpath/contact_frame.h"
#include "small_scan.h"
#include "support/expect_input_error.h"
#include "support/flat_plate.h"

namespace scan_to_path::pipeline {
namespace {

TEST(PathStage, ARealRunIsNotLifted) {
  const Cell cell = makeCell(CellOptions(), source_package);
  PathStage path;
  path.planned.path.segments = {{"row_0", std::vector<toolpath::Waypoint>(2)}};
  EXPECT_EQ(airRun(path, cell, {}).planned.path.segments[0].waypoints[1].pose.translation(), Vector3::Zero());
  program::ProgramOptions options;
  options.dry_offset = 0.05;
  EXPECT_EQ(airRun(path, cell, options).planned.path.lift, Vector3(0.0, 0.0, 0.05));
}

TEST(PathStage, NamesTheProcessesThatAreThere) {
  test::expectInputError([] { makePlanner("grinding", {}); }, "process 'grinding' is not known; known: cutting");
  EXPECT_EQ(makePlanner("cutting", {})->shortestPiece(), process::CuttingOptions().ball_radius);
}

// Row distances and gouges are found on the surface, whatever the rows follow.
TEST(PathStage, NeedsTheSurface) {
  JobOptions options;
  options.fit.with_surface = false;
  test::expectInputError([&] { makePlanner("cutting", options); }, "fit.with_surface is false");
  options.path.row_source = process::RowSource::scan_lines;
  test::expectInputError([&] { makePlanner("cutting", options); }, "path.row_source=scan_lines too");
}

// Beside it lies a fixture, or another robot's part: the plate is 0.117 m across.
TEST(PathStage, NotesAWorkObjectFarFromThePart) {
  JobOptions options;
  const auto scan = test::flatPlate();
  const auto notes = [&](double x) {
    options.cell.workpiece.xyz = {x, 0.03, 0.0};
    return pathStage(*makePlanner("cutting", options), scan, "base_link", options, {}).notes;
  };
  EXPECT_THAT(notes(0.05), ::testing::IsEmpty());
  EXPECT_THAT(notes(-0.49), ::testing::IsEmpty());
  EXPECT_THAT(notes(-0.51), ::testing::ElementsAre(::testing::HasSubstr(
                                "the part, 0.117 m across, lies 0.510 m from the work object's origin")));
}

// The region is the user's, over the work object frame: turned and moved there, it cuts the same of the part.
TEST(PathStage, TakesTheRegionInTheWorkObjectFrame) {
  JobOptions options;
  options.cell.workpiece.xyz = {0.5, -0.2, 0.3};
  options.cell.workpiece.rpy = {0.0, 0.0, 0.7};
  options.path.region = {{0.02, 0.01}, {0.07, 0.01}, {0.07, 0.05}, {0.02, 0.05}};
  options.path.skip_rows = "5";
  const auto T = geometry::makeFrame(options.cell.workpiece.xyz, options.cell.workpiece.rpy);
  const auto scan = test::flatPlate(T);
  const PathStage stage = pathStage(*makePlanner("cutting", options), scan, "base_link", options, {});
  Eigen::AlignedBox3d box;
  for (const auto& segment : stage.planned.path.segments) {
    for (std::size_t i = 0; toolpath::isRow(segment) && i < segment.waypoints.size(); ++i) {
      if (toolpath::isContact(segment, i)) box.extend(T.inverse() * segment.waypoints[i].pose.translation());
    }
  }
  EXPECT_NEAR(box.min().x(), 0.02, 1e-9);
  EXPECT_NEAR(box.max().x(), 0.07, 1e-9);
  EXPECT_GE(box.min().y(), 0.01);
  EXPECT_LE(box.max().y(), 0.05);
  EXPECT_TRUE(regionOf(options).contains(T * Vector3(0.03, 0.02, 9.0)));
  EXPECT_FALSE(regionOf(options).contains(T * Vector3(0.03, 0.06, 9.0)));
  EXPECT_THAT(stage.notes, ::testing::ElementsAre(::testing::HasSubstr("rows 5 are skipped (path.skip_rows)"),
                                                  ::testing::HasSubstr("only what lies in path.region")));
}

}  // namespace
}  // namespace scan_to_path::pipeline
