// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/row_pieces.h"

#include <gmock/gmock.h>

#include "support/tracks.h"

namespace scan_to_path::scan {
namespace {

using Runs = std::vector<Run>;  // in a test, Run is gtest's

using testing::ElementsAre;

Run runOf(const Track& track, std::size_t begin, std::size_t end, bool forward, int row) {
  Run run = makeRun(track, begin, end, forward);
  run.row = row;
  return run;
}

TEST(MakePieces, RunTowardsXFromTheOriginAndKeepTheirSamples) {
  const Track track = test::trackOf({{1, 5}, {2, 5}, {3, 5}, {3, 6}, {2, 6}, {1, 6}});
  Runs runs = {runOf(track, 3, 6, false, 1), runOf(track, 0, 3, true, 0)};
  const auto pieces = makePieces(track, runs, {1.0, 5.0, -2.0});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[1].row, 1);
  EXPECT_FALSE(pieces[1].forward);
  EXPECT_THAT(pieces[1].x, ElementsAre(0.0, 1.0, 2.0));
  EXPECT_THAT(pieces[1].y, ElementsAre(1.0, 1.0, 1.0));
  EXPECT_THAT(pieces[1].z, ElementsAre(2.0, 2.0, 2.0));
  EXPECT_THAT(pieces[1].index, ElementsAre(5, 4, 3));
}

TEST(MakePieces, RunsOfOneRowAndDirectionAreOnePiece) {
  const Track track = test::trackOf({{5, 0}, {6, 0}, {0, 0}, {1, 0}, {9, 0}, {8, 0}});
  Runs runs = {runOf(track, 0, 2, true, 0), runOf(track, 2, 4, true, 0), runOf(track, 4, 6, false, 0)};
  const auto pieces = makePieces(track, runs, Vector3::Zero());
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_THAT(pieces[0].x, ElementsAre(0.0, 1.0, 5.0, 6.0));
  EXPECT_THAT(pieces[1].index, ElementsAre(5, 4));
}

TEST(MakePieces, ShakingSamplesAreOrderedAndEqualOnesStayAsMeasured) {
  const Track track = test::trackOf({{2, 0}, {1, 0}, {2, 0}, {0, 0}, {3, 0}, {5, 0}, {4, 0}, {6, 0}});
  Runs runs = {runOf(track, 0, 8, true, 0)};
  const auto pieces = makePieces(track, runs, Vector3::Zero());
  EXPECT_THAT(pieces[0].x, ElementsAre(0.0, 1.0, 2.0, 2.0, 3.0, 4.0, 5.0, 6.0));
  EXPECT_THAT(pieces[0].index, ElementsAre(3, 1, 0, 2, 4, 6, 5, 7));
}

}  // namespace
}  // namespace scan_to_path::scan
