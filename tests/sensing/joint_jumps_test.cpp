// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/joint_jumps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_input_error.h"
#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

using test::expectInputError;
using test::SensingCell;

constexpr double count = 2.0 * M_PI / (131072.0 * 100.0);  // [rad] of joint 1
constexpr std::size_t place = 4000;                        // reading in the middle of a row

scan::SampleLog scanned(const SensingCell& cell, double joint_rate = 1000.0) {
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::realistic);
  options.joint_rate = joint_rate;
  return cell.emulate(options).log;
}

/// One encoder is off by some counts from a reading on, for `readings` of them.
scan::SampleLog slipped(scan::SampleLog log, std::size_t joint, double counts, std::size_t from,
                        std::size_t readings = 100000000) {
  for (std::size_t i = from; i < log.joint_time.size() && i < from + readings; ++i) log.counts[6 * i + joint] += counts;
  return log;
}

TEST(JointJumps, AreNoneInScansHoweverTheyAreRead) {
  const SensingCell cell = SensingCell::small();
  for (const double joint_rate : {1000.0, 250.0, 100.0}) EXPECT_NO_THROW(cell.place(scanned(cell, joint_rate)));
  // Stamps off by up to 0.4 ms either way, as of messages that wait for one another.
  auto log = scanned(cell);
  Random random(3);
  for (std::size_t i = 1; i + 1 < log.joint_time.size(); ++i)
    log.joint_time[i] += 4e-4 * (2.0 * random.uniform() - 1.0);
  EXPECT_NO_THROW(cell.place(log));
}

TEST(JointJumps, OfAnyJointAreRefused) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  for (std::size_t joint = 0; joint < 6; ++joint) {
    for (const double counts : {1000.0, -1000.0, 20000.0}) {
      const std::string name = "joint reading 4000 at 4.000000 s: joint_" + std::to_string(joint + 1) + " jumps by ";
      expectInputError([&] { cell.place(slipped(log, joint, counts, place)); }, name);     // a slip
      expectInputError([&] { cell.place(slipped(log, joint, counts, place, 1)); }, name);  // a bad reading
    }
  }
}

TEST(JointJumps, SmallerOnesThanTheLimitPassAndTheLimitIsTheUsers) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  EXPECT_NO_THROW(cell.place(slipped(log, 0, 40.0, place)));  // 19 urad: what a scan of 1 m reach sees of it is noise
  // The most that the limit of 50 urad lets pass: with it half a millisecond of the joint's motion at 50 mm/s and 0.8 m
  // from its axis, 31 urad, the bend that 10 rad/s^2 make of five readings, 20 urad, and four counts.
  const double largest = 50e-6 + 31e-6 + 20e-6 + 5.0 * count;
  EXPECT_THROW(cell.place(slipped(log, 0, std::ceil(largest / count), place)), InputError);
  PlacementOptions any;
  any.max_joint_jump = 0.0;
  EXPECT_NO_THROW(cell.place(slipped(log, 0, 20000.0, place), any));
  any.max_joint_jump = 0.02;
  EXPECT_NO_THROW(cell.place(slipped(log, 0, 20000.0, place), any));
  EXPECT_THROW(cell.place(slipped(log, 0, 60000.0, place), any), InputError);
}

TEST(JointJumps, AreFoundAtTheEndsAndBesideGaps) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  EXPECT_THROW(cell.place(slipped(log, 2, 1000.0, 0, 1)), InputError);
  EXPECT_THROW(cell.place(slipped(log, 2, 1000.0, log.joint_time.size() - 1)), InputError);
  auto gap = log;
  gap.joint_time.erase(gap.joint_time.begin() + place, gap.joint_time.begin() + place + 100);
  gap.counts.erase(gap.counts.begin() + 6 * place, gap.counts.begin() + 6 * (place + 100));
  EXPECT_NO_THROW(cell.place(gap)) << "over a gap of 0.1 s nothing is compared";
  EXPECT_THROW(cell.place(slipped(gap, 2, 1000.0, place + 1)), InputError);
}

TEST(JointJumps, TheFirstIsNamedForAnyNumberOfThreads) {
  const SensingCell cell = SensingCell::small();
  const auto log = slipped(slipped(scanned(cell), 4, 1000.0, 20000), 1, 1000.0, place);
  for (const int threads : {1, 2, 5}) {
    expectInputError([&] { cell.place(log, {}, threads); }, "joint reading 4000 at 4.000000 s: joint_2 jumps by ");
  }
}

}  // namespace
}  // namespace scan_to_path::sensing
