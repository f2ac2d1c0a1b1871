// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/path_stage.h"

#include <gmock/gmock.h>

#include "small_scan.h"
#include "support/expect_input_error.h"

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

}  // namespace
}  // namespace scan_to_path::pipeline
