// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/sample_log.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::scan {
namespace {

using test::expectInputError;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string start = "# scan_to_path samples 1\nt,joint_1,joint_2,voltage\n";

SampleLog parse(const std::string& rows) { return parseSampleLog(start + rows, "log.csv"); }

/// Joints on every fourth tick and a sensor that sometimes says nothing or fails.
SampleLog randomLog(std::uint64_t seed) {
  Random random(seed);
  SampleLog log;
  log.joint_names = {"joint_1", "joint_2", "joint_3"};
  for (int tick = 0; tick < 400; ++tick) {
    const double time = -0.1 + 0.001 * tick + 1e-6 * std::floor(random.uniform(0.0, 900.0));
    if (tick % 4 == 0) {
      log.joint_time.push_back(time);
      for (int joint = 0; joint < 3; ++joint) log.counts.push_back(random.uniform(-2147483648.0, 2147483648.0));
    }
    if (random.uniform() < 0.9) {
      log.sensor_time.push_back(time + (tick % 2) * 5e-5);
      log.voltage.push_back(random.uniform() < 0.02 ? std::nan("") : random.uniform(-10.0, 10.0));
    }
  }
  return log;
}

TEST(SampleLog, KeepsEveryChannelOnItsOwnTicks) {
  const SampleLog log = parse("0.000000,100,-200.5,1.25\n# a comment\n0.001,,,nan\n0.002,101,-201,\n");
  EXPECT_THAT(log.joint_names, ElementsAre("joint_1", "joint_2"));
  EXPECT_THAT(log.joint_time, ElementsAre(0.0, 0.002));
  EXPECT_THAT(log.counts, ElementsAre(100.0, -200.5, 101.0, -201.0));
  EXPECT_THAT(log.sensor_time, ElementsAre(0.0, 0.001));
  EXPECT_DOUBLE_EQ(log.voltage[0], 1.25);
  EXPECT_TRUE(std::isnan(log.voltage[1]));
}

TEST(SampleLog, TakesBlanksExponentsAndDosLineEnds) {
  const SampleLog log =
      parseSampleLog("# scan_to_path samples 1\r\nt, a ,voltage\r\n 0 , 1e3 , +2.5 \r\n\r\n1,2,3", "log.csv");
  EXPECT_THAT(log.joint_names, ElementsAre("a"));
  EXPECT_THAT(log.counts, ElementsAre(1000.0, 2.0));
  EXPECT_THAT(log.voltage, ElementsAre(2.5, 3.0));
}

TEST(SampleLog, SkipsAByteOrderMark) {
  const std::string text = "# scan_to_path samples 1\nt,joint_1,voltage\n0.5,3,1.25\n";
  EXPECT_EQ(parseSampleLog("\xEF\xBB\xBF" + text, "log").voltage, parseSampleLog(text, "log").voltage);
  EXPECT_THROW(parseSampleLog("\xEF\xBB" + text, "log"), InputError);
}

TEST(SampleLog, NumbersAreRoundedCorrectly) {
  const SampleLog log = parse("0.1,123456789012345678901,0.30000000000000004,-0.000001\n");
  EXPECT_EQ(log.joint_time[0], 0.1);
  EXPECT_EQ(log.counts[0], 123456789012345678901.0);
  EXPECT_EQ(log.counts[1], 0.30000000000000004);
  EXPECT_EQ(log.voltage[0], -0.000001);
}

TEST(SampleLog, RoundTripKeepsWhatTheHeaderPromises) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SampleLog log = randomLog(seed);
    const SampleLog again = parseSampleLog(formatSampleLog(log), "again");
    ASSERT_EQ(again.joint_names, log.joint_names);
    ASSERT_EQ(again.joint_time.size(), log.joint_time.size());
    ASSERT_EQ(again.voltage.size(), log.voltage.size());
    for (std::size_t i = 0; i < log.counts.size(); ++i) EXPECT_NEAR(again.counts[i], log.counts[i], 1e-3);
    for (std::size_t i = 0; i < log.joint_time.size(); ++i) EXPECT_NEAR(again.joint_time[i], log.joint_time[i], 1e-6);
    for (std::size_t i = 0; i < log.voltage.size(); ++i) {
      EXPECT_NEAR(again.sensor_time[i], log.sensor_time[i], 1e-6);
      EXPECT_EQ(std::isnan(again.voltage[i]), std::isnan(log.voltage[i]));
      if (!std::isnan(log.voltage[i])) {
        EXPECT_NEAR(again.voltage[i], log.voltage[i], 1e-6);
      }
    }
    EXPECT_EQ(formatSampleLog(again), formatSampleLog(log));  // idempotent
  }
}

TEST(SampleLog, TimesOnTheMicrosecondGridAreExact) {
  SampleLog log;
  log.joint_names = {"a"};
  for (int i = 0; i < 1000; ++i) {
    log.joint_time.push_back(i * 1001 / 1e6);
    log.sensor_time.push_back(i * 1001 / 1e6);
    log.counts.push_back(i);
    log.voltage.push_back(0.0);
  }
  const std::string text = formatSampleLog(log);
  EXPECT_THAT(text, HasSubstr("\n0.001001,1,0.000000\n"));
  EXPECT_EQ(parseSampleLog(text, "log").joint_time, log.joint_time);
}

TEST(SampleLog, ErrorsNameTheLine) {
  const auto fails = [](const std::string& rows, const std::string& message) {
    expectInputError([&] { parse(rows); }, message);
  };
  fails("0,1,2,3\n0,1,2,3\n", "log.csv line 4: t is 0.000000, must be after");
  fails("1,1,2,3\n0.5,1,2,3\n", "log.csv line 4: t is 0.500000, must be after that of the row before, 1.000000");
  fails("nan,1,2,3\n", "log.csv line 3: t is nan, must be finite");
  fails("0,1,2\n", "log.csv line 3: number of cells is 3, must be 4");
  fails("0,1,2,3,4\n", "log.csv line 3: number of cells is more than 4");
  fails("0,1,,3\n", "log.csv line 3: number of joints with counts is 1, must be 0 or 2");
  fails("0,inf,2,3\n", "log.csv line 3: joint_1 is inf, must be finite");
  fails("0,1,nan,3\n", "log.csv line 3: joint_2 is nan, must be finite");
  fails("0,1,2,inf\n", "log.csv line 3: voltage is inf, must be finite");
  fails("0,1,2,x\n", "log.csv line 3: voltage is 'x', must be a number");
  fails("0,1,2.5.1,3\n", "log.csv line 3: joint_2 is '2.5.1', must be a number");
  fails(",1,2,3\n", "log.csv line 3: t is empty");
  fails("0,,,\n", "log.csv line 3: row is empty but for its time");
  fails("", "log.csv: number of sensor samples is 0");
  fails("0,1,2,\n", "log.csv: number of sensor samples is 0");
  fails("0,,,1\n", "log.csv: number of joint readings is 0");
}

TEST(SampleLog, RefusesOtherFiles) {
  const auto fails = [](const std::string& text, const std::string& message) {
    expectInputError([&] { parseSampleLog(text, "f"); }, message);
  };
  fails("", "f line 1: first line");
  fails("solid cube\n", "f line 1: first line");
  fails("# scan_to_path samples 1\n", "f line 1: header is missing");
  fails("# scan_to_path samples 1\na,b\n", "f line 2: header is 'a,b'");
  fails("# scan_to_path samples 1\nt,a,a,voltage\n", "f line 2: joint name is 'a', must be unique");
  fails("# scan_to_path samples 1\nt,,voltage\n", "f line 2: joint name is ''");
  expectInputError([] { readSampleLog("/nonexistent/samples.csv"); }, "/nonexistent/samples.csv");
}

TEST(SampleLog, FormatterRefusesWhatCouldNotBeReadBack) {
  SampleLog log = randomLog(1);
  log.voltage[0] = INFINITY;
  expectInputError([&] { formatSampleLog(log); }, "voltage");
  log = randomLog(1);
  log.counts[5] = NAN;
  expectInputError([&] { formatSampleLog(log); }, "count");
  log = randomLog(1);
  log.counts.pop_back();
  expectInputError([&] { formatSampleLog(log); }, "number of counts");
  log = randomLog(1);
  log.sensor_time[1] = log.sensor_time[0] + 1e-8;
  expectInputError([&] { formatSampleLog(log); }, "at least 1 us after");
}

TEST(SampleLog, AnyCutOrFlippedByteIsReadOrRefused) {
  const std::string text = formatSampleLog(randomLog(3));
  Random random(4);
  for (int round = 0; round < 500; ++round) {
    std::string damaged = text.substr(0, static_cast<std::size_t>(random.uniform() * static_cast<double>(text.size())));
    if (!damaged.empty()) damaged[random.bits() % damaged.size()] = static_cast<char>(random.bits());
    try {
      const SampleLog log = parseSampleLog(damaged, "damaged");
      EXPECT_EQ(log.counts.size(), log.joint_time.size() * log.joint_names.size());
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace scan_to_path::scan
