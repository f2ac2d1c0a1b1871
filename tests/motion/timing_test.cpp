// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/timing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "scan_to_path/common/random.h"

namespace scan_to_path::motion {
namespace {

double total(const std::vector<double>& durations) { return std::accumulate(durations.begin(), durations.end(), 0.0); }

TEST(MoveDurations, OfOneMoveAreATrapezoid) {
  // 0.1 m at 0.2 m/s and 1 m/s^2: two ramps of 0.2 s and 0.02 m each, 0.06 m at full speed.
  const auto durations = moveDurations({{0.1, 0.0, 0.2, false}}, 1.0);
  ASSERT_EQ(durations.size(), 1u);
  EXPECT_NEAR(durations[0], 0.2 + 0.2 + 0.06 / 0.2, 1e-12);
}

TEST(MoveDurations, OfAShortMoveAreATriangle) {
  // Too short for 0.2 m/s: the peak is sqrt(a s).
  EXPECT_NEAR(moveDurations({{0.01, 0.0, 0.2, false}}, 1.0)[0], 2.0 * std::sqrt(0.01), 1e-12);
}

TEST(MoveDurations, DoNotDependOnHowALineIsCut) {
  const double whole = total(moveDurations({{0.1, 0.0, 0.2, false}}, 1.0));
  EXPECT_NEAR(total(moveDurations(std::vector<TimedMove>(1000, {1e-4, 0.0, 0.2, false}), 1.0)), whole, 1e-9);
}

TEST(MoveDurations, StopsTakeTheirRamps) {
  std::vector<TimedMove> moves(2, {0.1, 0.0, 0.2, false});
  EXPECT_NEAR(total(moveDurations(moves, 1.0)), 0.2 / 0.2 + 0.2, 1e-12);
  moves[0].stop = true;
  EXPECT_NEAR(total(moveDurations(moves, 1.0)), 2.0 * (0.1 / 0.2 + 0.2), 1e-12);
}

TEST(MoveDurations, JointsThatAreTooSlowTakeTheirTime) {
  // 0.1 m that the joints need 2 s for: 0.05 m/s.
  EXPECT_NEAR(moveDurations({{0.1, 2.0, 0.2, false}}, 1.0)[0], 0.1 / 0.05 + 0.05, 1e-12);
  EXPECT_EQ(moveDurations({{0.0, 2.0, 0.2, false}}, 1.0)[0], 2.0);
}

TEST(MoveDurations, NeverFasterThanFeedJointsOrAcceleration) {
  Random random(1);
  for (int k = 0; k < 500; ++k) {
    std::vector<TimedMove> moves;
    for (int i = 0; i < 50; ++i) {
      const double length = random.uniform() < 0.1 ? 0.0 : std::pow(10.0, random.uniform(-6, -1));  // 2 us at 0.5 m/s
      const double joint_time = random.uniform() < 0.3 ? 0.0 : std::pow(10.0, random.uniform(-6, 0));
      moves.push_back({length, joint_time, random.uniform(0.001, 0.5), random.uniform() < 0.05});
    }
    const double acceleration = random.uniform(0.1, 5.0);
    const auto durations = moveDurations(moves, acceleration);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      ASSERT_TRUE(std::isfinite(durations[i]));
      ASSERT_GE(durations[i], 2e-6);
      ASSERT_GE(durations[i] * (1 + 1e-12), moves[i].joint_time);
      ASSERT_LE(moves[i].length / durations[i], moves[i].feed * (1 + 1e-12));
      if (i > 0 && moves[i].length > 0.0 && moves[i - 1].length > 0.0) {
        // Mean speeds of neighbours differ by at most the acceleration times the time between their middles.
        const double v0 = moves[i - 1].length / durations[i - 1], v1 = moves[i].length / durations[i];
        ASSERT_LE(std::abs(v1 - v0), acceleration * (durations[i] + durations[i - 1]) * (1 + 1e-9));
      }
    }
  }
}

TEST(MoveDurations, OfNothingAreNothing) { EXPECT_TRUE(moveDurations({}, 1.0).empty()); }

}  // namespace
}  // namespace scan_to_path::motion
