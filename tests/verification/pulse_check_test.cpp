// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/pulse_check.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "scan_to_path/common/random.h"
#include "scan_to_path/motion/trajectory.h"

namespace scan_to_path::verification {
namespace {

using ::testing::HasSubstr;

/// With a parallelogram: the controller's third axis is the sum of joints 2 and 3.
robot::Robot sixJoints() {
  robot::Robot robot;
  robot.joints.resize(6);
  robot.coupled_axis = robot::CoupledAxis{2, {1, 2}, -1.0, 1.0};
  return robot;
}

/// A coupled wrist, axes that count backwards, and no two settings alike.
robot::EncoderOptions settings() {
  robot::EncoderOptions options;
  options.counts_per_turn = {131072, 65536, 131072, 8192, 4096, 131072};
  options.gear_ratio = {100, 121, 90.5, 80, 70, 50};
  options.sign = {1, -1, 1, 1, -1, 1};
  options.offset = {0.1, -0.2, 0.0, 0.3, 0.0, 1.0};
  options.coupling.assign(36, 0.0);
  for (std::size_t i = 0; i < 6; ++i) options.coupling[7 * i] = 1.0;
  options.coupling[5 * 6 + 4] = 0.02;
  return options;
}

robot::Encoders encoders() { return robot::Encoders(settings(), sixJoints()); }

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

PulseCheck check(const std::string& text) { return checkPulses(text, trajectory(), settings(), sixJoints()); }

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

/// What the check finds in the file of a cell whose settings are not the check's.
double differenceBy(const std::function<void(robot::EncoderOptions&, robot::Robot&)>& change) {
  robot::EncoderOptions options = settings();
  robot::Robot robot = sixJoints();
  change(options, robot);
  const std::string written = motion::formatPulses(trajectory(), robot::Encoders(options, robot));
  return checkPulses(written, trajectory(), settings(), sixJoints()).largest_difference;
}

// Angles of up to 3 rad are some 1e6 counts: a thousandth of any setting is more than a hundred of them.
TEST(PulseCheck, EverySettingMatters) {
  using Options = robot::EncoderOptions;
  EXPECT_LE(differenceBy([](Options&, robot::Robot&) {}), 0.5 + 1e-6);
  EXPECT_GT(differenceBy([](Options& options, robot::Robot&) { options.sign[3] = -1.0; }), 100.0);
  EXPECT_GT(differenceBy([](Options& options, robot::Robot&) { options.gear_ratio[0] *= 1.001; }), 100.0);
  EXPECT_GT(differenceBy([](Options& options, robot::Robot&) { options.counts_per_turn[5] *= 1.001; }), 100.0);
  EXPECT_GT(differenceBy([](Options& options, robot::Robot&) { options.offset[1] += 0.001; }), 100.0);
  EXPECT_GT(differenceBy([](Options& options, robot::Robot&) { options.coupling[5 * 6 + 4] = 0.03; }), 100.0);
  EXPECT_GT(differenceBy([](Options& options, robot::Robot&) { options.coupling.clear(); }), 100.0);
  EXPECT_GT(differenceBy([](Options&, robot::Robot& robot) { robot.coupled_axis->joints = {0, 2}; }), 100.0);
  EXPECT_GT(differenceBy([](Options&, robot::Robot& robot) { robot.coupled_axis.reset(); }), 100.0);
}

}  // namespace
}  // namespace scan_to_path::verification
