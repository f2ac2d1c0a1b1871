// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/short_moves.h"

#include <gmock/gmock.h>

namespace scan_to_path::pipeline {
namespace {

toolpath::ToolPath twoSegments() {
  toolpath::ToolPath path;
  path.segments = {{"approach", std::vector<toolpath::Waypoint>(2)}, {"row_0", std::vector<toolpath::Waypoint>(4)}};
  return path;
}

motion::Trajectory trajectoryOf(const std::vector<motion::TrajectoryPoint>& points) {
  motion::Trajectory trajectory;
  trajectory.points = points;
  return trajectory;
}

/// Moves of 1 s, 0.1 s and then 10, 3 and 4 ms; the one of 10 ms has points between, each less than 4 ms apart.
motion::Trajectory someShortMoves() {
  return trajectoryOf({{0.0, 0, 0, {}},
                       {1.0, 0, 1, {}},
                       {1.1, 1, 0, {}},
                       {1.103, 1, 1, {}},
                       {1.106, 1, 1, {}},
                       {1.110, 1, 1, {}},
                       {1.113, 1, 2, {}},
                       {1.117, 1, 3, {}}});
}

TEST(ShortMoves, NoneIsAFigureAndNoNote) {
  for (const double shortest : {0.0, 0.003}) {
    const ShortMoves found = shortMoves(twoSegments(), someShortMoves(), shortest);
    ASSERT_EQ(found.accuracy.size(), 1U);
    EXPECT_EQ(found.accuracy[0].name, "short_moves");
    EXPECT_EQ(found.accuracy[0].value, 0.0);
    EXPECT_TRUE(found.accuracy[0].pass());
    EXPECT_FALSE(found.note);
  }
}

TEST(ShortMoves, CountsThemFromWaypointToWaypointAndNamesTheShortest) {
  ShortMoves found = shortMoves(twoSegments(), someShortMoves(), 0.004);
  ASSERT_EQ(found.accuracy.size(), 2U);
  EXPECT_EQ(found.accuracy[0].value, 1.0);
  EXPECT_EQ(found.accuracy[1].name, "shortest_move");
  EXPECT_NEAR(found.accuracy[1].value, 0.003, 1e-12);
  EXPECT_EQ(found.accuracy[1].unit, "s");
  EXPECT_TRUE(found.accuracy[0].pass() && found.accuracy[1].pass()) << "a note, no failure";
  EXPECT_EQ(
      found.note,
      "1 of 5 moves last less than 4.000 ms (motion.shortest_move_time), the shortest 3.000 ms, to row_0 waypoint "
      "2: a controller may stutter there; lower the feed, or raise path.chord_tolerance for fewer waypoints");
  found = shortMoves(twoSegments(), someShortMoves(), 0.011);
  EXPECT_EQ(found.accuracy[0].value, 3.0);
  EXPECT_NEAR(found.accuracy[1].value, 0.003, 1e-12);
}

TEST(ShortMoves, WithoutMovesThereAreNone) {
  EXPECT_FALSE(shortMoves({}, {}, 0.004).note);
  EXPECT_FALSE(shortMoves(twoSegments(), trajectoryOf({{0.0, 0, 0, {}}}), 0.004).note);
}

}  // namespace
}  // namespace scan_to_path::pipeline
