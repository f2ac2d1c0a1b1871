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
constexpr double limit = 5e-5;                             // [rad], the default
constexpr std::size_t place = 4000;                        // reading in the middle of a row, at 1 kHz

scan::SampleLog scanned(const SensingCell& cell, double joint_rate = 1000.0, double acceleration = 1.0,
                        double speed = 0.05, RasterOrder order = RasterOrder::zig_zag) {
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::realistic);
  options.joint_rate = joint_rate;
  options.raster.acceleration = acceleration;
  options.raster.speed = speed;
  options.raster.order = order;
  return cell.emulate(options).log;
}

/// One encoder is off by some counts from a reading on, for `readings` of them; it gets there within `over` readings.
scan::SampleLog slipped(scan::SampleLog log, std::size_t joint, double counts, std::size_t from,
                        std::size_t readings = 100000000, std::size_t over = 1) {
  for (std::size_t i = from; i < log.joint_time.size() && i < from + readings; ++i) {
    const double share = std::min(1.0, static_cast<double>(i - from + 1) / static_cast<double>(over));
    log.counts[6 * i + joint] += std::round(share * counts);
  }
  return log;
}

scan::SampleLog without(scan::SampleLog log, std::size_t from, std::size_t readings) {
  const auto begin = static_cast<std::ptrdiff_t>(from), end = begin + static_cast<std::ptrdiff_t>(readings);
  log.joint_time.erase(log.joint_time.begin() + begin, log.joint_time.begin() + end);
  log.counts.erase(log.counts.begin() + 6 * begin, log.counts.begin() + 6 * end);
  return log;
}

/// Stamps off by up to `most` [s] either way; of the samples' as well, if they share the readings' lines.
scan::SampleLog jittered(scan::SampleLog log, double most, bool samples_too) {
  Random random(3);
  for (std::size_t i = 1; i < log.joint_time.size(); ++i) {
    const double off = most * (2.0 * random.uniform() - 1.0);
    log.joint_time[i] = std::max(log.joint_time[i] + off, log.joint_time[i - 1] + 1e-6);
    if (samples_too) log.sensor_time[i] = log.joint_time[i];
  }
  return log;
}

/// Every reading repeated until the next of a controller that gives one in `readings`.
scan::SampleLog held(scan::SampleLog log, std::size_t readings) {
  for (std::size_t i = 0; i < log.joint_time.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) log.counts[6 * i + k] = log.counts[6 * (i - i % readings) + k];
  }
  return log;
}

UnseenJumps look(const SensingCell& cell, const scan::SampleLog& log, int threads = 1) {
  const robot::Encoders encoders = cell.encoders();
  const JointReadings readings(log, cell.robot, encoders, PlacementOptions().max_joint_gap);
  const geometry::Vector3 spot_tip = cell.T_tip_sensor * geometry::Vector3(0.0, 0.0, 0.08);
  return checkJointJumps(readings, cell.robot, spot_tip,
                         {limit, PlacementOptions().max_joint_gap, std::vector<double>(6, count)}, threads);
}

TEST(JointJumps, AreNoneInScansAtAnyRateSpeedAndAcceleration) {
  const SensingCell cell = SensingCell::small();
  for (const double rate : {1000.0, 250.0, 100.0, 50.0}) {
    for (const double acceleration : {0.2, 1.0, 10.0}) {
      for (const double speed : {0.05, 0.1}) {
        SCOPED_TRACE(std::to_string(rate) + " Hz, " + std::to_string(acceleration) + " m/s^2, " +
                     std::to_string(speed) + " m/s");
        const auto log = scanned(cell, rate, acceleration, speed);
        EXPECT_NO_THROW(look(cell, log));
        EXPECT_NO_THROW(look(cell, without(log, 0, log.joint_time.size() / 3))) << "begins in full motion";
      }
    }
  }
}

TEST(JointJumps, AreNoneInReadingsThatComeUnevenly) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  EXPECT_NO_THROW(look(cell, jittered(log, 4e-4, false)));
  for (const double most : {6e-4, 2e-3, 5e-3}) {
    UnseenJumps unseen;
    EXPECT_NO_THROW(unseen = look(cell, jittered(log, most, true)));
    if (most < 1e-3) {
      EXPECT_LT(unseen.distance, 1e-3) << "and the job need not fail";
    }
  }
  auto pairs = log;  // two at a time, as from a buffer
  for (std::size_t i = 1; i < pairs.joint_time.size(); i += 2) pairs.joint_time[i] = pairs.joint_time[i - 1] + 1e-5;
  EXPECT_NO_THROW(look(cell, pairs));
  auto lossy = log;
  for (std::size_t i = 100; i + 100 < lossy.joint_time.size(); i += 97) lossy = without(std::move(lossy), i, 1 + i % 3);
  EXPECT_NO_THROW(look(cell, lossy));
  for (const std::size_t readings : {2, 4, 10}) EXPECT_NO_THROW(look(cell, held(log, readings))) << readings;
}

TEST(JointJumps, OfAnyJointAreRefused) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  for (std::size_t joint = 0; joint < 6; ++joint) {
    for (const double counts : {1000.0, -1000.0, 20000.0}) {
      const std::string name = "joint reading 4000 at 4.000000 s: joint_" + std::to_string(joint + 1) + " jumps by ";
      expectInputError([&] { look(cell, slipped(log, joint, counts, place)); }, name);     // a slip
      expectInputError([&] { look(cell, slipped(log, joint, counts, place, 1)); }, name);  // a bad reading
      EXPECT_THROW(look(cell, slipped(log, joint, counts, place, 3)), InputError) << "bad for a while";
    }
  }
}

// In the rows, where the speed is even, the most that passes is the limit with half a millisecond of motion at up to
// 0.07 rad/s, four counts and what the readings' errors make of the speed: 120 urad, whatever the rate.
TEST(JointJumps, InTheRowsAreRefusedAtAnyRateOfReadings) {
  const SensingCell cell = SensingCell::small();
  for (const double rate : {1000.0, 250.0, 100.0, 50.0}) {
    const auto log = scanned(cell, rate);
    for (const double second : {1.5, 2.5, 3.5, 7.0, 8.0}) {  // rows take 5.1 s
      const auto from = static_cast<std::size_t>(second * rate);
      for (const std::size_t joint : {0, 1, 2, 4}) {
        EXPECT_THROW(look(cell, slipped(log, joint, 120e-6 / count, from)), InputError)
            << rate << " Hz, joint " << joint + 1 << ", at " << second << " s";
      }
    }
  }
}

TEST(JointJumps, ThatTakeAFewReadingsAreRefused) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  for (const std::size_t over : {2, 3, 5, 8, 10}) {
    for (std::size_t from = place; from < place + 16; ++from) {
      EXPECT_THROW(look(cell, slipped(log, 1, 300e-6 / count, from, 100000000, over)), InputError)
          << over << " readings from " << from;
    }
  }
}

// In a row a robot may change its speed, but not its path.
TEST(JointJumps, ThatLeaveThePathSlowlyAreRefused) {
  const SensingCell cell = SensingCell::small();
  for (const double rate : {1000.0, 250.0, 100.0}) {
    const auto log = scanned(cell, rate);
    for (const double seconds : {0.015, 0.03, 0.06}) {
      const auto over = static_cast<std::size_t>(seconds * rate);
      for (const double begin : {1.5, 2.513, 3.527, 7.541}) {
        const auto from = static_cast<std::size_t>(begin * rate);
        EXPECT_THROW(look(cell, slipped(log, 1, 400e-6 / count, from, 100000000, over)), InputError)
            << rate << " Hz, " << seconds << " s from " << begin << " s";
        EXPECT_THROW(look(cell, slipped(log, 0, -5000.0, from, 100000000, over)), InputError)
            << rate << " Hz, " << seconds << " s from " << begin << " s";
      }
    }
  }
}

TEST(JointJumps, AreNoneWhereTheSpeedChangesInARow) {
  const SensingCell cell = SensingCell::small();
  auto log = scanned(cell);
  for (const double begin : {1.5, 2.5, 3.5, 7.5}) {
    for (double& t : log.joint_time) {  // a fifth slower, then a fifth faster, within 120 ms
      const double u = (t - begin) / 0.12;
      if (u > 0.0 && u < 1.0) t += 0.2 / (2.0 * M_PI) * 0.12 * (1.0 - std::cos(2.0 * M_PI * u));
    }
  }
  EXPECT_NO_THROW(look(cell, log));
}

TEST(JointJumps, SmallerOnesThanTheLimitPassAndTheLimitIsTheUsers) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  EXPECT_NO_THROW(cell.place(slipped(log, 0, 40.0, place)));  // 19 urad: what a scan of 1 m reach sees of it is noise
  PlacementOptions any;
  any.max_joint_jump = 0.0;
  EXPECT_NO_THROW(cell.place(slipped(log, 0, 20000.0, place), any));
  any.max_joint_jump = 0.02;
  EXPECT_NO_THROW(cell.place(slipped(log, 0, 20000.0, place), any));
  EXPECT_THROW(cell.place(slipped(log, 0, 60000.0, place), any), InputError);
}

TEST(JointJumps, AreFoundAtTheEnds) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  EXPECT_THROW(look(cell, slipped(log, 2, 1000.0, 0, 1)), InputError);
  EXPECT_THROW(look(cell, slipped(log, 2, 1000.0, log.joint_time.size() - 1)), InputError);
}

TEST(JointJumps, AcrossGapsInTheRowsAreRefused) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanned(cell);
  for (const std::size_t readings : {60, 100}) {
    const auto gap = without(log, place - 1500, readings);
    EXPECT_NO_THROW(look(cell, gap)) << "even motion explains " << readings;
    for (const double counts : {-400.0, 400.0, 20000.0}) {  // 190 urad and more
      SCOPED_TRACE(std::to_string(readings) + " readings lost, then " + std::to_string(counts) + " counts");
      expectInputError([&] { look(cell, slipped(gap, 1, counts, place - 1500)); }, " s in the readings, ");
    }
    EXPECT_THROW(look(cell, slipped(gap, 2, 1000.0, place - 1499)), InputError) << "beside the gap";
  }
  // The longer nobody looks, the more can hide: within half a second the speed may change anywhere.
  EXPECT_GT(look(cell, without(log, place - 1500, 500)).angle, 400.0 * count);
}

TEST(JointJumps, BetweenRestsAreCountedAsPauses) {
  const SensingCell cell = SensingCell::small();
  for (const double rate : {1000.0, 250.0, 100.0}) {
    const auto unseen = look(cell, scanned(cell, rate, 1.0, 0.05, RasterOrder::one_way));
    EXPECT_EQ(unseen.pauses, 4u) << rate << " Hz: five rows, each recorded by itself";
  }
  EXPECT_EQ(look(cell, scanned(cell)).pauses, 0u);
}

TEST(JointJumps, CannotBeLookedForInReadingsThatAreFarApart) {
  const SensingCell cell = SensingCell::small();
  auto log = scanned(cell);
  for (double& t : log.joint_time) t *= 1000.0;
  expectInputError([&] { look(cell, log); }, "times are in seconds: are these milliseconds?");
}

// Whatever passes unseen is no larger than what the log is said to be able to hide.
TEST(JointJumps, ThatMotionCouldHideAreMeasured) {
  const SensingCell cell = SensingCell::small();
  Random random(11);
  int passed = 0;
  for (const double rate : {1000.0, 250.0, 100.0, 50.0}) {
    const auto log = scanned(cell, rate);
    const UnseenJumps unseen = look(cell, log);
    // Steps over 8 ms or more in a ramp of 1 m/s^2, 0.8 m to 0.9 m from the axis, before and after a turn.
    const double ramp = 1.0 / 0.85 * std::pow(std::max(1.0 / rate, 0.008), 2);
    EXPECT_LT(unseen.angle, 8.0 * ramp) << rate;
    for (int i = 0; i < 100; ++i) {
      // Every second one within 0.1 s of where most could hide.
      const double anywhere = random.uniform(0.1, log.joint_time.back() - 0.1);
      const bool is_near = i % 2 == 0 && unseen.distance > 0.0;
      const double second = is_near ? unseen.time + random.uniform(-0.1, 0.1) : anywhere;
      const auto from = static_cast<std::size_t>(second * rate);
      const double jump = (random.uniform() < 0.5 ? -1.0 : 1.0) * random.uniform(1e-4, 3e-3);
      try {
        const auto seen = look(cell, slipped(log, 0, jump / count, from));
        EXPECT_LE(std::abs(jump), seen.angle + limit + 5e-4 * 0.07 + 5.0 * count) << rate << " Hz, reading " << from;
        ++passed;
      } catch (const InputError&) {
      }
    }
  }
  EXPECT_GT(passed, 0) << "at 50 Hz turns of the robot hide some";
}

TEST(JointJumps, TheFirstIsNamedForAnyNumberOfThreads) {
  const SensingCell cell = SensingCell::small();
  const auto log = slipped(slipped(scanned(cell), 4, 1000.0, 20000), 1, 1000.0, place);
  for (const int threads : {1, 2, 5}) {
    expectInputError([&] { look(cell, log, threads); }, "joint reading 4000 at 4.000000 s: joint_2 jumps by ");
  }
}

}  // namespace
}  // namespace scan_to_path::sensing
