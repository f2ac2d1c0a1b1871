// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/pulse_check.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "scan_to_path/motion/trajectory.h"

namespace scan_to_path::verification {
namespace {

using ::testing::HasSubstr;

/// A coupled wrist and axes that count backwards.
robot::Robot sixJoints() {
  robot::Robot robot;
  robot.joints.resize(6);
  return robot;
}

robot::Encoders encoders() {
  robot::EncoderOptions options;
  options.sign = {1, -1, 1, 1, -1, 1};
  options.offset = {0.1, -0.2, 0.0, 0.3, 0.0, 1.0};
  options.coupling.assign(36, 0.0);
  for (std::size_t i = 0; i < 6; ++i) options.coupling[7 * i] = 1.0;
  options.coupling[5 * 6 + 4] = 0.02;
  return robot::Encoders(options, sixJoints());
}

motion::Trajectory trajectory() {
  Random random(11);
  motion::Trajectory made;
  made.joint_names = {"a", "b", "c", "d", "e", "f"};
  for (int i = 0; i < 50; ++i) {
    robot::JointVector q(6);
    for (int j = 0; j < 6; ++j) q[j] = random.uniform(-3.0, 3.0);
    made.points.push_back({0.0123456 * i, i / 10, i % 10, q});
  }
  return made;
}

PulseCheck check(const std::string& text) { return checkPulses(text, trajectory(), encoders()); }

std::string text() { return motion::formatPulses(trajectory(), encoders()); }

/// The cell of a line, both from 0, replaced.
std::string withCell(std::string text, std::size_t line, std::size_t column, const std::string& by) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < line; ++i) at = text.find('\n', at) + 1;
  for (std::size_t i = 0; i < column; ++i) at = text.find(',', at) + 1;
  return text.replace(at, text.find_first_of(",\n", at) - at, by);
}

TEST(PulseCheck, RoundingIsHalfACount) {
  const PulseCheck found = check(text());
  EXPECT_EQ(found.points, 50U);
  EXPECT_EQ(found.mismatches, 0U);
  EXPECT_EQ(found.first_mismatch, "");
  // Half a count, and rounding of 1e8 counts at 16 digits.
  EXPECT_LE(found.largest_difference, 0.5 + 1e-6);
  EXPECT_GT(found.largest_difference, 0.4);  // of 300 roundings, one is almost sure to be near half a count
}

TEST(PulseCheck, MutationTwinsAreFound) {
  const auto count = [](long off) {
    const double exact = encoders().counts(trajectory().points[9].q)[2];
    return std::to_string(std::lround(exact) + off);
  };
  EXPECT_LE(check(withCell(text(), 10, 5, count(0))).largest_difference, 0.5 + 1e-6);
  EXPECT_GT(check(withCell(text(), 10, 5, count(2))).largest_difference, 1.0);
  EXPECT_GT(check(withCell(text(), 10, 5, count(-2))).largest_difference, 1.0);
  EXPECT_THAT(check(withCell(text(), 10, 0, "0.112000")).first_mismatch, HasSubstr("point 9 is at another time"));
  EXPECT_THAT(check(withCell(text(), 10, 1, "1")).first_mismatch, HasSubstr("point 9 names another waypoint"));
  EXPECT_THAT(check(withCell(text(), 10, 2, "8")).first_mismatch, HasSubstr("point 9 names another waypoint"));
  EXPECT_THAT(check(withCell(text(), 0, 4, "z")).first_mismatch, HasSubstr("other joints"));
  EXPECT_EQ(check(withCell(text(), 10, 5, "1e")).mismatches, 1U);
  std::string shorter = text();
  shorter.resize(shorter.rfind('\n', shorter.size() - 2) + 1);
  EXPECT_THAT(check(shorter).first_mismatch, HasSubstr("has 49 points, the trajectory 50"));
}

// A pulse file of another cell: what one encoder's settings wrote, another's read.
TEST(PulseCheck, OtherEncodersAreFound) {
  robot::EncoderOptions options;
  const robot::Encoders plain(options, sixJoints());
  EXPECT_GT(checkPulses(motion::formatPulses(trajectory(), plain), trajectory(), encoders()).largest_difference, 1e3);
}

}  // namespace
}  // namespace scan_to_path::verification
