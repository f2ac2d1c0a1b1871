// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/joint_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::sensing {
namespace {

using Status = JointReadings::Status;

constexpr double max_gap = 0.05;

robot::Robot twoJoints() {
  robot::Robot robot;
  robot.name = "two";
  robot.joints.resize(2);
  robot.joints[0].name = "a";
  robot.joints[1].name = "b";
  return robot;
}

/// One count is one radian.
robot::Encoders unitEncoders() {
  robot::EncoderOptions options;
  options.counts_per_turn = {2.0 * M_PI, 2.0 * M_PI};
  options.gear_ratio = options.sign = {1.0, 1.0};
  options.offset = {0.0, 0.0};
  return {options, twoJoints()};
}

/// Joint a follows `angle`, joint b minus twice that.
scan::SampleLog logOf(const std::vector<double>& times, const std::function<double(double)>& angle) {
  scan::SampleLog log;
  log.joint_names = {"a", "b"};
  log.joint_time = times;
  for (const double t : times) {
    log.counts.push_back(angle(t));
    log.counts.push_back(-2.0 * angle(t));
  }
  return log;
}

std::vector<double> unevenTimes(int count) {
  Random random(5);
  std::vector<double> times = {1.0};
  while (static_cast<int>(times.size()) < count) times.push_back(times.back() + random.uniform(0.001, 0.009));
  return times;
}

double angleAt(const JointReadings& readings, double time, int joint = 0) {
  robot::JointVector angles;
  std::size_t cursor = 0;
  EXPECT_EQ(readings.anglesAt(time, cursor, angles), Status::found);
  return angles[joint];
}

double largestError(const scan::SampleLog& log, const std::function<double(double)>& angle) {
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  const JointReadings readings(log, robot, encoders, max_gap);
  double largest = 0.0;
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const double t = random.uniform(log.joint_time.front(), log.joint_time.back());
    largest = std::max(largest, std::abs(angleAt(readings, t) - angle(t)));
    largest = std::max(largest, std::abs(angleAt(readings, t, 1) + 2.0 * angle(t)));
  }
  return largest;
}

TEST(JointReadings, ConstantAccelerationIsReproducedOnUnevenTimes) {
  const auto angle = [](double t) { return 0.3 + 2.0 * t - 1.5 * t * t; };
  // Rounding of four products of size 5.
  EXPECT_LT(largestError(logOf(unevenTimes(200), angle), angle), 1e-14);
}

TEST(JointReadings, TwoReadingsAreJoinedStraight) {
  const auto angle = [](double t) { return 0.3 + 2.0 * t; };
  EXPECT_LT(largestError(logOf({0.0, 0.01}, angle), angle), 1e-15);
}

TEST(JointReadings, SmoothMotionIsThirdOrder) {
  const auto angle = [](double t) { return std::sin(7.0 * t); };
  const auto errorAt = [&](double step) {
    std::vector<double> times;
    for (int i = 0; i < 400; ++i) times.push_back(step * i);
    return largestError(logOf(times, angle), angle);
  };
  // The end intervals have a slope off by -h^2 f'''/3 at the end and h^2 f'''/6 at the other: u (1 - u) (2 - u) / 6 of
  // h^3 f''' between, at most 0.385 / 6; twice that for joint b.
  EXPECT_LE(errorAt(0.004), 2.0 * std::pow(0.004 * 7.0, 3) * 0.385 / 6.0);
  EXPECT_NEAR(errorAt(0.004) / errorAt(0.002), 8.0, 0.5);
}

TEST(JointReadings, OnAReadingItIsThatReading) {
  const auto angle = [](double t) { return std::sin(40.0 * t); };
  const auto log = logOf(unevenTimes(100), angle);
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  const JointReadings readings(log, robot, encoders, max_gap);
  for (std::size_t i = 0; i < log.joint_time.size(); ++i) {
    EXPECT_EQ(angleAt(readings, log.joint_time[i]), encoders.angles(&log.counts[2 * i])[0]);
  }
}

TEST(JointReadings, AnyCursorGivesTheSame) {
  const auto log = logOf(unevenTimes(50), [](double t) { return std::sin(9.0 * t); });
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  const JointReadings readings(log, robot, encoders, max_gap);
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const double t = random.uniform(log.joint_time.front(), log.joint_time.back());
    std::size_t cursor = static_cast<std::size_t>(random.uniform(0.0, 60.0));
    robot::JointVector angles;
    ASSERT_EQ(readings.anglesAt(t, cursor, angles), Status::found);
    EXPECT_EQ(angles[0], angleAt(readings, t));
    EXPECT_LE(log.joint_time[cursor], t);
  }
}

TEST(JointReadings, NothingBeyondTheReadingsOrInGaps) {
  const auto angle = [](double t) { return t < 0.05 ? t : 100.0; };
  const auto log = logOf({0.0, 0.01, 0.02, 0.1, 0.11, 0.12}, angle);
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  const JointReadings readings(log, robot, encoders, max_gap);
  robot::JointVector angles;
  std::size_t cursor = 0;
  EXPECT_EQ(readings.anglesAt(-1e-9, cursor, angles), Status::outside);
  EXPECT_EQ(readings.anglesAt(0.12 + 1e-9, cursor, angles), Status::outside);
  EXPECT_EQ(readings.anglesAt(std::nan(""), cursor, angles), Status::outside);
  EXPECT_EQ(readings.anglesAt(0.05, cursor, angles), Status::gap);
  EXPECT_EQ(readings.anglesAt(0.12, cursor, angles), Status::found);
  EXPECT_EQ(readings.anglesAt(0.0, cursor, angles), Status::found);
  // Slopes beside the gap do not look across it.
  EXPECT_NEAR(angleAt(readings, 0.015), 0.015, 1e-15);
  EXPECT_NEAR(angleAt(readings, 0.105), 100.0, 1e-12);
}

TEST(JointReadings, JointsMayComeInAnyOrder) {
  auto log = logOf({0.0, 0.01}, [](double t) { return 1.0 + t; });
  log.joint_names = {"b", "a"};
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  const JointReadings readings(log, robot, encoders, max_gap);
  EXPECT_NEAR(angleAt(readings, 0.005, 1), 1.005, 1e-15);
}

TEST(JointReadings, CounterWrapsAreUndone) {
  const double range = 4294967296.0;  // 2^32
  const auto turning = [](double t) { return 2.1e9 + 6.0e9 * t; };
  std::vector<double> times;
  for (int i = 0; i < 100; ++i) times.push_back(0.01 * i);
  const auto straight = logOf(times, turning);
  auto wrapped = straight;
  for (auto& count : wrapped.counts) {
    count -= range * std::floor((count + 0.5 * range) / range);  // as a signed 32-bit counter shows it
  }
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  const JointReadings truth(straight, robot, encoders, max_gap);
  const JointReadings readings(wrapped, robot, encoders, max_gap);
  // Where the counter stood before the log began nobody knows: whole ranges are left open.
  const double first = angleAt(truth, 0.0, 1) - angleAt(readings, 0.0, 1);
  EXPECT_EQ(std::fmod(first, range), 0.0);
  for (const double t : {0.004, 0.2, 0.3331, 0.99}) {
    EXPECT_NEAR(angleAt(readings, t), angleAt(truth, t), 1e-5);
    EXPECT_NEAR(angleAt(readings, t, 1) + first, angleAt(truth, t, 1), 1e-5);
  }
}

// A controller that gives new counts every 4 ms, read every 1 ms: what it gave is what counts, at the time it came.
TEST(JointReadings, RepeatedOnesCountOnce) {
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  const auto turning = [](double t) { return t < 1.0 ? 1000.0 * t * t : 1000.0; };  // and then at rest
  std::vector<double> times, slow;
  for (int i = 0; i < 2000; ++i) times.push_back(0.001 * i);
  for (int i = 0; i < 500; ++i) slow.push_back(0.004 * i);
  auto log = logOf(times, turning);
  for (std::size_t i = 0; i < log.counts.size(); ++i) log.counts[i] = log.counts[i / 8 * 8 + i % 2];
  const auto given = logOf(slow, turning);
  const JointReadings held(log, robot, encoders, max_gap), truth(given, robot, encoders, max_gap);
  EXPECT_EQ(truth.timesRepeated(), 1U);
  ASSERT_EQ(held.timesRepeated(), 4U);
  ASSERT_EQ(held.size(), truth.size()) << "at rest one in four as well";
  EXPECT_EQ(held.placeInLog(10), 40U);
  for (double t = 0.0; t < 1.996; t += 0.0007) EXPECT_EQ(angleAt(held, t), angleAt(truth, t)) << t;
}

TEST(JointReadings, ARestIsNoRepetition) {
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) times.push_back(0.001 * i);
  const auto log = logOf(times, [](double t) { return t < 0.2 ? 1000.0 * t : 200.0; });
  EXPECT_EQ(JointReadings(log, robot, encoders, max_gap).timesRepeated(), 1U);
}

TEST(JointReadings, BadLogsAreNamed) {
  const auto good = logOf({0.0, 0.01, 0.02}, [](double t) { return t; });
  const robot::Robot robot = twoJoints();
  const robot::Encoders encoders = unitEncoders();
  const auto expectError = [&](auto&& spoil, const std::string& part) {
    auto log = good;
    spoil(log);
    test::expectInputError([&] { JointReadings(log, robot, encoders, max_gap); }, part);
  };
  expectError([](auto& log) { log.joint_names[1] = "bb"; },
              "no column for joint b of robot two, the nearest column is");
  expectError([](auto& log) { log.counts.pop_back(); }, "number of counts is 5, must be 2 for each of 3 readings");
  expectError([](auto& log) { log.joint_time[2] = 0.01; }, "joint reading 2: time is 0.010000 s");
  expectError([](auto& log) { log.joint_time[0] = -std::numeric_limits<double>::infinity(); }, "joint reading 0: time");
  expectError([](auto& log) { log.counts[3] = std::nan(""); }, "joint reading 1: count of b is nan, must be finite");
  expectError(
      [](auto& log) {
        log.joint_names.push_back("c");
        log.counts.resize(9);
      },
      "number of joints is 3, must be 2");
}

}  // namespace
}  // namespace scan_to_path::sensing
