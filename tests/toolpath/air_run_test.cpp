// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/air_run.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scan_to_path/toolpath/modifiers.h"
#include "support/expect_input_error.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

namespace scan_to_path::toolpath {
namespace {

ToolPath planned() {
  return withLinks(withLeads(test::planeRows(3, 0.004, 0.1, 5, true), {}), Vector3::UnitZ(), 0.02, {});
}

TEST(AirRun, EveryWaypointIsLiftedAndWorksNoMore) {
  const ToolPath part = planned();
  const Vector3 lift(0.01, 0.0, 0.05);
  const ToolPath air = lifted(part, lift);
  ASSERT_EQ(air.segments.size(), part.segments.size());
  for (std::size_t s = 0; s < part.segments.size(); ++s) {
    ASSERT_EQ(air.segments[s].waypoints.size(), part.segments[s].waypoints.size());
    for (std::size_t i = 0; i < part.segments[s].waypoints.size(); ++i) {
      const Waypoint& on = part.segments[s].waypoints[i];
      const Waypoint& off = air.segments[s].waypoints[i];
      EXPECT_LT((off.pose.translation() - on.pose.translation() - lift).norm(), 1e-15);
      EXPECT_EQ((off.pose.linear() - on.pose.linear()).norm(), 0.0);
      EXPECT_EQ(off.feed, on.feed);
      EXPECT_FALSE(off.process_on);
    }
  }
}

TEST(AirRun, TwiceEqualsOnce) {
  const Vector3 lift(0.0, 0.0, 0.05);
  const ToolPath once = lifted(planned(), lift);
  EXPECT_EQ(test::largestDifference(lifted(once, lift), once), 0.0);
}

TEST(AirRun, MovesWithThePath) {
  Random random(3);
  const Frame T = test::randomFrame(random);
  const Vector3 lift(0.01, 0.0, 0.05);
  const ToolPath a = lifted(test::moved(planned(), T), T.linear() * lift);
  EXPECT_LT(test::largestDifference(a, test::moved(lifted(planned(), lift), T)), 1e-14);
}

TEST(AirRun, MustLeadAwayFromTheSurface) {
  // 59 degrees between lift and normal leave more than half of it, 61 degrees less.
  const auto leaning = [](double degrees) {
    const double angle = degrees * M_PI / 180.0;
    return Vector3(0.05 * std::sin(angle), 0.0, 0.05 * std::cos(angle));
  };
  EXPECT_NO_THROW(lifted(planned(), leaning(59.0)));
  test::expectInputError([&] { lifted(planned(), leaning(61.0)); }, "segment row_0 waypoint 1: lift of the air run");
  test::expectInputError([&] { lifted(planned(), {0.0, 0.0, -0.05}); }, "is -50.000 mm");
  test::expectInputError([&] { lifted(planned(), {0.0, 0.0, std::nan("")}); }, "not finite");
}

TEST(AirRun, PathFileSaysSo) {
  const ToolPath air = lifted(planned(), {0.01, 0.0, 0.05});
  const std::string text = formatToolPath(air);
  EXPECT_THAT(text, ::testing::HasSubstr("\n# lift 0.010000000 0.000000000 0.050000000\n"));
  EXPECT_EQ((parseToolPath(text, "path.csv").lift - air.lift).norm(), 0.0);
  EXPECT_THAT(formatToolPath(planned()), ::testing::Not(::testing::HasSubstr("lift")));
  std::string broken = text;
  broken.replace(broken.find("# lift 0.01"), 18, "# lift");
  test::expectInputError([&] { parseToolPath(broken, "path.csv"); }, "lift must have the three numbers");
}

}  // namespace
}  // namespace scan_to_path::toolpath
