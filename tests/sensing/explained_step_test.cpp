// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/sensing/explained_step.h"

#include <gtest/gtest.h>

#include <functional>

#include "scan_to_path/common/random.h"

namespace scan_to_path::sensing {
namespace {

using Motion = std::function<double(double)>;

/// Readings of a motion at 0, -1, -2 … or 1, 2, 3 … times `interval`.
SideReadings readBefore(const Motion& motion, double interval, int count = 3) {
  SideReadings side;
  for (int k = 0; k < count; ++k) side.addFarther(-k * interval, motion(-k * interval), 0.0);
  return side;
}

SideReadings readAfter(const Motion& motion, double interval, int count = 3) {
  SideReadings side;
  for (int k = 1; k <= count; ++k) side.addFarther(k * interval, motion(k * interval), 0.0);
  return side;
}

ExplainedStep explained(const Motion& motion, double interval) {
  return explainedStep(readBefore(motion, interval), readAfter(motion, interval));
}

TEST(ExplainedStep, IsThatOfEvenMotionAndNoOther) {
  const ExplainedStep step = explained([](double t) { return 3.0 + 2.0 * t; }, 0.01);
  EXPECT_NEAR(step.low, 0.02, 1e-14);
  EXPECT_NEAR(step.high, 0.02, 1e-14);
  EXPECT_NEAR(step.speed, 2.0, 1e-12);
  EXPECT_NEAR(step.excess(0.03), 0.01, 1e-14);
  EXPECT_NEAR(step.excess(-0.01), 0.03, 1e-14);
}

// Constant acceleration a over an interval T: the step lies within those of the speeds at both ends, a T^2 apart, and
// of the nearest readings' mean speeds, 3/2 a T^2 off either way at most.
TEST(ExplainedStep, IsNotWiderThanAccelerationMakesIt) {
  constexpr double a = 5.0, interval = 0.01, bend = a * interval * interval;
  const Motion motion = [](double t) { return 0.3 * t + 0.5 * a * t * t; };
  const ExplainedStep step = explained(motion, interval);
  EXPECT_EQ(step.excess(motion(interval)), 0.0);
  EXPECT_NEAR(step.low, 0.3 * interval - 0.5 * bend, 1e-14);
  EXPECT_NEAR(step.high, 0.3 * interval + 1.5 * bend, 1e-14);
}

// Whatever a motion does within the interval, once: go on, start, stop, turn, or change from one acceleration to
// another. Speeds and accelerations of either side are random, positions and speeds are continuous.
TEST(ExplainedStep, CoversMotionThatChangesOnce) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const double interval = random.uniform(0.001, 0.02), change = random.uniform() * interval;
    const double speed = random.uniform(-0.5, 0.5), before = random.uniform(-10.0, 10.0);
    const double after = random.uniform() < 0.3 ? 0.0 : random.uniform(-10.0, 10.0);
    const Motion motion = [&](double t) {
      const double u = t - change;
      return speed * u + 0.5 * (u < 0.0 ? before : after) * u * u;
    };
    const double step = motion(interval) - motion(0.0);
    EXPECT_LT(explained(motion, interval).excess(step), 1e-12) << i;
  }
}

TEST(ExplainedStep, OneSideAloneLeavesStartAndStopOpen) {
  const Motion motion = [](double t) { return 2.0 * t; };
  const ExplainedStep first = explainedStep(readBefore(motion, 0.01, 1), readAfter(motion, 0.01));
  EXPECT_NEAR(first.low, 0.0, 1e-14);
  EXPECT_NEAR(first.high, 0.02, 1e-14);
  const ExplainedStep last = explainedStep(readBefore(motion, 0.01), readAfter(motion, 0.01, 1));
  EXPECT_NEAR(last.excess(-0.01), 0.01, 1e-14);
  EXPECT_EQ(explainedStep(readBefore(motion, 0.01, 1), readAfter(motion, 0.01, 1)).excess(0.02), 0.0)
      << "two readings alone show no motion";
}

TEST(RestingNextTo, TellsStoppingFromGoingOn) {
  constexpr double interval = 0.01, resolution = 1e-6;
  const auto stopping = [](double rest) {  // decelerates until it rests at that time, before or after 0
    return [rest](double t) { return t < rest ? -0.5 * (t - rest) * (t - rest) : 0.0; };
  };
  EXPECT_TRUE(isRestingNextTo(readBefore(stopping(-0.05), interval), resolution)) << "rests";
  EXPECT_TRUE(isRestingNextTo(readBefore(stopping(0.01), interval), resolution)) << "about to";
  EXPECT_FALSE(isRestingNextTo(readBefore(stopping(0.05), interval), resolution)) << "not yet";
  EXPECT_FALSE(isRestingNextTo(readBefore([](double t) { return 0.1 * t; }, interval), resolution));
  const auto starting = [](double t) { return t > 0.0 ? 0.5 * t * t : 0.0; };
  EXPECT_TRUE(isRestingNextTo(readAfter(starting, interval), resolution)) << "has just started";
  EXPECT_FALSE(isRestingNextTo(readAfter([](double t) { return 0.1 * t; }, interval), resolution));
  EXPECT_FALSE(isRestingNextTo(readBefore(starting, interval, 1), resolution)) << "a reading alone shows nothing";
}

}  // namespace
}  // namespace scan_to_path::sensing
