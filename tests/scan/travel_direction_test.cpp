// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/travel_direction.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/expect_input_error.h"
#include "support/tracks.h"

namespace scan_to_path::scan {
namespace {

std::vector<Anchors> anchorsOf(const Track& track, double window = 0.3) {
  return {findAnchors(track, {0, track.size()}, window)};
}

TEST(FindAnchors, AreAWindowApartAndEndWithTheStretch) {
  Track track = test::trackOf({{0, 0}});
  test::goTo(track, 1.0, 0.0, 40);
  EXPECT_THAT(findAnchors(track, {0, 41}, 0.26), testing::ElementsAre(0, 11, 22, 33, 40));
  EXPECT_THAT(findAnchors(track, {5, 6}, 0.26), testing::ElementsAre(5));
}

TEST(RowDirection, IsThatOfTheRowsWhateverTheirSenseAndTheTurns) {
  for (const double angle : {0.0, 0.4, 1.5, 2.9, -1.2}) {
    Track track = test::zigZag(7);
    rotate(track, {std::cos(angle), -std::sin(angle)});  // rows now run at `angle`
    const Vector2 axis = rowDirection(track, anchorsOf(track));
    EXPECT_NEAR(std::abs(axis.dot(Vector2(std::cos(angle), std::sin(angle)))), 1.0, 1e-12) << angle;
  }
}

TEST(RowDirection, AWindingWayHasNone) {
  Track circle = test::trackOf({{1, 0}});
  for (int k = 1; k <= 600; ++k) test::goTo(circle, std::cos(0.01047 * k), std::sin(0.01047 * k), 1);
  test::expectInputError([&] { rowDirection(circle, anchorsOf(circle, 0.05)); },
                         "share of samples travelling along one direction is 0.0");
  test::expectInputError([&] { rowDirection(circle, {}); }, "travelling along one direction is 0.00");
}

}  // namespace
}  // namespace scan_to_path::scan
