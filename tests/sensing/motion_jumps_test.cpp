// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/motion_jumps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"

namespace scan_to_path::sensing {
namespace {

constexpr double interval = 0.004;  // [s]
constexpr double allowed = 5e-5;

/// Three coordinates on swings of their own.
class Swings : public MotionReadings {
public:
  explicit Swings(Random& random, std::size_t size = 20000) : size_(size) {
    for (double& phase : phase_) phase = random.uniform(0.0, 6.0);
  }

  std::size_t size() const override { return size_; }
  double timeOf(std::size_t reading) const override { return interval * static_cast<double>(reading); }
  robot::JointVector valuesOf(std::size_t reading) const override {
    robot::JointVector values(3);
    for (int k = 0; k < 3; ++k) values[k] = 0.05 * std::sin((1.0 + k) * timeOf(reading) + phase_[k]);
    if (reading >= jump_at) values[jumping] += jump;
    return values;
  }

  std::size_t jump_at = 0;
  int jumping = 0;
  double jump = 0.0;

private:
  std::size_t size_;
  double phase_[3];
};

MotionJumps find(const MotionReadings& readings, int threads = 1) {
  return findMotionJumps(readings, {allowed, 0.05, std::vector<double>(3, 1e-9)}, threads);
}

TEST(MotionJumps, AreNoneInSwings) {
  Random random(1);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(find(Swings(random)).first) << i;
}

// What hides a jump is half a millisecond of up to 0.15/s, 75e-6, and what 0.45/s^2 bend within 4 ms, 14e-6.
TEST(MotionJumps, AreNamedByReadingAndCoordinate) {
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    Swings swings(random);
    swings.jump_at = static_cast<std::size_t>(random.uniform(10.0, 19990.0));
    swings.jumping = i % 3;
    swings.jump = (i % 2 == 0 ? 1.0 : -1.0) * (allowed + 100e-6);
    for (const int threads : {1, 3}) {
      const auto found = find(swings, threads);
      ASSERT_TRUE(found.first) << swings.jump_at;
      EXPECT_EQ(found.first->reading, swings.jump_at);
      EXPECT_EQ(found.first->coordinate, swings.jumping);
      const double off = std::max(found.first->step - found.first->high, found.first->low - found.first->step);
      EXPECT_NEAR(off, allowed + 100e-6, 30e-6) << "two bends";
    }
  }
}

TEST(MotionJumps, OfTwoReadingsOrLessAreNone) {
  Random random(3);
  for (const std::size_t size : {0, 1, 2}) EXPECT_FALSE(find(Swings(random, size)).first);
}

}  // namespace
}  // namespace scan_to_path::sensing
