// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../../src/program/planned_moves.h"

#include <gtest/gtest.h>

#include "program_cases.h"
#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

using geometry::Vector3;

/// Waypoints along a right-angled corner, 10 mm apart; their joint angles do not matter here.
ProgramInput corner(bool process_on) {
  ProgramInput input;
  input.robot = test::irb2400WithLinkage();
  input.path.segments.push_back({"row_0", {}});
  for (int i = 0; i < 6; ++i) {
    test::addWaypoint(input, test::joints({0, 0, 0, 0, 0, 0}), 0.02, process_on && i > 0);
    auto& pose = input.path.segments[0].waypoints.back().pose;
    pose = Frame::Identity();
    pose.translation() = i < 3 ? Vector3(0.01 * i, 0, 0) : Vector3(0.02, 0.01 * (i - 2), 0);
  }
  return input;
}

TEST(PlannedMoves, ZonesAreRoundedDownWithinTheTolerance) {
  // Straight: half the spacing, 5 mm, which is a step. Corner: 10 um / sin 45 degrees = 14.1 um, rounded down.
  const auto on = plannedMoves(corner(true));
  EXPECT_EQ(on[0].zone, 0.0);  // the process starts behind it
  EXPECT_EQ(on[1].zone, 5e-3);
  EXPECT_EQ(on[2].zone, 10e-6);
  EXPECT_EQ(on[4].zone, 5e-3);
  EXPECT_EQ(on[5].zone, 0.0);
  // In the air: 0.5 mm / sin 45 degrees = 0.71 mm, rounded down to 0.5 mm.
  EXPECT_EQ(plannedMoves(corner(false))[2].zone, 0.5e-3);
  auto tight = corner(true);
  tight.options.zone_tolerance = 5e-6;
  EXPECT_EQ(plannedMoves(tight)[2].zone, 0.0);
}

TEST(PlannedMoves, TargetsAreInTheWorkobject) {
  auto input = corner(false);
  Random random(2);
  input.T_base_path = test::randomFrame(random, 0.5);
  input.T_base_workobject = test::randomFrame(random, 0.5);
  input.path.T_contact_tcp = test::randomFrame(random, 0.01);
  const auto moves = plannedMoves(input);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Frame planned = input.T_base_path * input.path.segments[0].waypoints[i].pose * input.path.T_contact_tcp;
    EXPECT_TRUE((input.T_base_workobject * moves[i].T_workobject_tcp).isApprox(planned, 1e-13));
  }
}

TEST(PlannedMoves, FirstMoveHasTheStartSpeed) {
  auto input = corner(false);
  input.path.segments[0].waypoints[0].feed = 0.0;
  EXPECT_EQ(plannedMoves(input)[0].feed, input.options.start_speed);
  EXPECT_EQ(plannedMoves(input)[1].feed, 0.02);
}

TEST(PlannedMoves, TheFeedIsTheOneThatTheMotionDrives) {
  auto input = corner(true);
  input.plan.feeds[3] = 0.013;
  const auto moves = plannedMoves(input);
  EXPECT_EQ(moves[2].feed, 0.02);
  EXPECT_EQ(moves[3].feed, 0.013);
  EXPECT_EQ(moves[4].feed, 0.02);
}

TEST(PlannedMoves, AnAirRunsPathIsLiftedByItsOffset) {
  auto input = corner(false);
  input.options.dry_offset = 0.03;
  test::expectInputError([&] { plannedMoves(input); }, "lift of the path is 0.000000 mm");
  input.path.lift = Vector3(0.0, 0.018, 0.024);
  EXPECT_NO_THROW(plannedMoves(input));
  input.options.dry_offset = 0.0;
  test::expectInputError([&] { plannedMoves(input); }, "lift of the path is 30.000000 mm");
}

}  // namespace
}  // namespace scan_to_path::program
