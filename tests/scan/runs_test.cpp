// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/runs.h"

#include <gmock/gmock.h>

#include "support/expect_input_error.h"
#include "support/tracks.h"

namespace scan_to_path::scan {
namespace {

using Runs = std::vector<Run>;  // in a test, Run is gtest's

std::vector<Run> runsOf(const Track& track, bool lines_given = false) {
  return findRuns(track, {findAnchors(track, {0, track.size()}, 0.3)}, lines_given);
}

TEST(MakeRun, KnowsItsExtent) {
  const auto run = makeRun(test::trackOf({{9, 9}, {2, 1}, {-1, 3}, {0, 2}, {9, 9}}), 1, 4, false);
  EXPECT_EQ(run.low, -1.0);
  EXPECT_EQ(run.high, 2.0);
  EXPECT_EQ(run.y, 2.0);
  EXPECT_FALSE(run.forward);
}

TEST(FindRuns, EndWhereTheTurnBegins) {
  const Track track = test::zigZag(5);
  const Runs runs = runsOf(track);
  ASSERT_EQ(runs.size(), 5U);
  for (std::size_t row = 0; row < 5; ++row) {
    EXPECT_EQ(runs[row].forward, row % 2 == 0);
    EXPECT_EQ(runs[row].begin, 110 * row) << "row " << row;  // 100 steps and ten for the turn: exact to the sample
    EXPECT_EQ(runs[row].end, 110 * row + 101);
    EXPECT_NEAR(runs[row].y, static_cast<double>(row), 1e-12);
  }
}

TEST(FindRuns, ASampleAtAReversalIsInOneRunOnly) {
  Track track = test::trackOf({{0, 0}});
  test::goTo(track, 10.0, 0.0, 100);
  test::goTo(track, 0.0, 0.02, 100);  // back at once
  const Runs runs = runsOf(track);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].end, runs[1].begin);
  EXPECT_EQ(runs[1].end, track.size());
}

TEST(FindRuns, GivenLinesAreWhole) {
  Track track = test::trackOf({{5, 0}});
  test::goTo(track, 5.0, 3.0, 30);
  test::goTo(track, 0.0, 3.0, 50);
  const Runs runs = runsOf(track, true);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].end, track.size());
  EXPECT_FALSE(runs[0].forward);
}

TEST(KeepLongRuns, DropsThoseOfFewSamplesOrShort) {
  Track track = test::trackOf({{0, 0}});
  test::goTo(track, 10.0, 0.0, 100);
  RowOptions options;
  options.min_samples = 8;
  options.min_length = 0.75;
  Runs runs = {makeRun(track, 0, 7, true), makeRun(track, 10, 18, true), makeRun(track, 20, 29, true)};
  keepLongRuns(runs, options);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].begin, 20U);
  options.min_samples = 10;
  test::expectInputError([&] { keepLongRuns(runs, options); },
                         "samples on the longest scan row is 9, must be at least 10");
}

}  // namespace
}  // namespace scan_to_path::scan
