// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/row_order.h"

#include <gmock/gmock.h>

#include "support/expect_input_error.h"
#include "support/tracks.h"

namespace scan_to_path::scan {
namespace {

using Runs = std::vector<Run>;  // in a test, Run is gtest's

Run runOver(double low, double high, double y) {
  Run run;
  run.low = low;
  run.high = high;
  run.y = y;
  return run;
}

std::vector<int> rowsOf(std::vector<Run> runs, double pitch) {
  const int count = numberRows(runs, pitch, 0.1);
  EXPECT_EQ(count, runs.back().row + 1);
  std::vector<int> rows;
  for (const Run& run : runs) rows.push_back(run.row);
  return rows;
}

TEST(MedianPitch, IsOfRunsBesideEachOtherOnly) {
  // The second half of row 0 has a neighbour at y = 4; runs that only follow each other along x have no distance.
  EXPECT_EQ(medianPitch({runOver(0, 4, 0), runOver(6, 9, 0.2), runOver(0, 9, 4), runOver(0, 9, 8)}, 0.1), 4.0);
  test::expectInputError(
      [] {
        medianPitch({runOver(0, 4, 0), runOver(4.05, 9, 4)}, 0.1);
      },
      "at least 2 that lie beside each other");
}

TEST(NumberRows, RunsAtOnePlaceAcrossShareARowUnlessTheyOverlap) {
  EXPECT_THAT(rowsOf({runOver(0, 4, 0.0), runOver(5, 9, 0.2), runOver(0, 9, 4.0), runOver(0, 9, 6.0)}, 4.0),
              testing::ElementsAre(0, 0, 1, 2));
  EXPECT_THAT(rowsOf({runOver(0, 4, 0.0), runOver(3, 9, 0.2)}, 4.0), testing::ElementsAre(0, 1));
  EXPECT_THAT(rowsOf({runOver(0, 4, 0.0), runOver(5, 9, 1.1)}, 4.0), testing::ElementsAre(0, 1));
}

TEST(CheckOrder, RowsThatCrossAreRefused) {
  const auto order = [](double y_begin, double y_end) {
    Track track = test::trackOf({{0.0, 0.0}});
    test::goTo(track, 10.0, 0.0, 100);
    const Track second = test::trackOf({{10.0, y_end}});
    track.x.push_back(second.x[0]);
    track.y.push_back(second.y[0]);
    track.z.push_back(0.0);
    track.index.push_back(101);
    test::goTo(track, 0.0, y_begin, 100);
    Runs runs = {makeRun(track, 0, 101, true), makeRun(track, 101, 202, false)};
    runs[0].row = 0;
    runs[1].row = 1;
    checkOrder(track, runs, 0.1);
  };
  EXPECT_NO_THROW(order(1.0, 0.2));
  test::expectInputError([&] { order(1.0, -0.3); }, "scan cloud: rows 0 and 1 cross");
  test::expectInputError([&] { order(-0.3, 1.0); }, "scan cloud: rows 0 and 1 cross");
  test::expectInputError([&] { order(-0.3, 1.0); }, "the viewing direction is wrong (a cloud's viewpoint or scan.beam");
}

}  // namespace
}  // namespace scan_to_path::scan
