// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/encoders.h"

#include <gmock/gmock.h>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/random.h"
#include "support/irb2400.h"

namespace scan_to_path::robot {
namespace {

Robot chainOf(std::size_t joints) {
  Robot robot;
  robot.joints.resize(joints);
  return robot;
}

TEST(Encoders, OneJointTurnIsCountsTimesGear) {
  const Encoders encoders(EncoderOptions(), chainOf(6));
  std::vector<double> counts(6, 0.0);
  counts[3] = 131072.0 * 100.0;
  JointVector expected = JointVector::Zero(6);
  expected[3] = 2.0 * M_PI;
  EXPECT_LT((encoders.angles(counts.data()) - expected).norm(), 1e-15);
}

TEST(Encoders, SignAndOffsetByHand) {
  EncoderOptions options;
  options.counts_per_turn = {1000, 2000};
  options.gear_ratio = {10, 50};
  options.sign = {1, -1};
  options.offset = {0.5, -0.25};
  const Encoders encoders(options, chainOf(2));
  const std::array<double, 2> counts = {2500, 25000};  // a quarter of a turn each
  const JointVector q = encoders.angles(counts.data());
  EXPECT_NEAR(q[0], 0.5 + M_PI_2, 1e-15);
  EXPECT_NEAR(q[1], -0.25 - M_PI_2, 1e-15);
}

TEST(Encoders, CouplingActsOnTheUncoupledAngles) {
  EncoderOptions options;
  options.counts_per_turn = options.gear_ratio = {1.0, 1.0};
  options.sign = {1, 1};
  options.offset = {0, 0};
  options.coupling = {1, 0, 0.5, 1};  // the second joint turns half of what the first motor does
  const std::array<double, 2> counts = {1.0, 0.0};
  const JointVector q = Encoders(options, chainOf(2)).angles(counts.data());
  EXPECT_NEAR(q[0], 2.0 * M_PI, 1e-15);
  EXPECT_NEAR(q[1], M_PI, 1e-15);
}

// The motor of the IRB 2400's axis 3 turns joint_2 + joint_3: standing still, it holds the upper arm's slope.
TEST(Encoders, MotorsTurnTheControllersAxes) {
  const Robot robot = test::irb2400WithLinkage();
  const double turn = 131072.0 * 100.0;
  std::vector<double> counts(6, 0.0);
  counts[1] = turn / 8.0;
  const JointVector q = Encoders(EncoderOptions(), robot).angles(counts.data());
  EXPECT_NEAR(q[1], M_PI / 4.0, 1e-15);
  EXPECT_NEAR(q[2], -M_PI / 4.0, 1e-15);
  EXPECT_LT((forwardKinematics(robot, q).linear() - forwardKinematics(robot, JointVector::Zero(6)).linear()).norm(),
            1e-15);
  Random random(6);
  for (int k = 0; k < 100; ++k) {
    JointVector joints(6);
    for (int i = 0; i < 6; ++i) joints[i] = random.uniform(-1.0, 1.0);
    const JointVector expected = controllerAxes(robot, joints) * (turn / (2.0 * M_PI));
    // Counts of 2e6, a few roundings.
    EXPECT_LT((Encoders(EncoderOptions(), robot).counts(joints) - expected).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(Encoders, CountsInvertAngles) {
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    EncoderOptions options;
    options.coupling.resize(36);
    for (std::size_t i = 0; i < 36; ++i) options.coupling[i] = (i % 7 == 0 ? 1.0 : 0.0) + random.uniform(-0.1, 0.1);
    for (std::size_t i = 0; i < 6; ++i) {
      options.sign[i] = random.uniform() < 0.5 ? 1.0 : -1.0;
      options.offset[i] = random.uniform(-3, 3);
    }
    const Encoders encoders(options, k % 2 == 0 ? chainOf(6) : test::irb2400WithLinkage());
    JointVector q(6);
    for (int i = 0; i < 6; ++i) q[i] = random.uniform(-3, 3);
    const JointVector counts = encoders.counts(q);
    // Condition of the coupling is below 4, of the linkage below 3; a few roundings of angles below 10 rad.
    EXPECT_LT((encoders.angles(counts.data()) - q).cwiseAbs().maxCoeff(), 1e-14 * 12);
  }
}

TEST(Encoders, BadOptionsAreNamed) {
  const auto message = [](auto&& change) -> std::string {
    EncoderOptions options;
    change(options);
    try {
      Encoders encoders(options, chainOf(6));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  using testing::HasSubstr;
  EXPECT_THAT(message([](EncoderOptions& o) { o.gear_ratio.pop_back(); }), HasSubstr("gear_ratio"));
  EXPECT_THAT(message([](EncoderOptions& o) { o.counts_per_turn[2] = 0; }), HasSubstr("counts_per_turn: value 2"));
  EXPECT_THAT(message([](EncoderOptions& o) { o.counts_per_turn[2] = INFINITY; }), HasSubstr("value 2"));
  EXPECT_THAT(message([](EncoderOptions& o) { o.sign[5] = 0.5; }), HasSubstr("sign: value 5"));
  EXPECT_THAT(message([](EncoderOptions& o) { o.offset[0] = NAN; }), HasSubstr("offset: value 0"));
  EXPECT_THAT(message([](EncoderOptions& o) { o.coupling.assign(36, 1.0); }), HasSubstr("invertible"));
  EXPECT_THAT(message([](EncoderOptions& o) { o.coupling.assign(6, 1.0); }), HasSubstr("coupling"));
}

TEST(UnwrapCount, UndoesWrapsBothWays) {
  constexpr double range = 4294967296.0;
  EXPECT_EQ(unwrapCount(2147483640.0, -2147483646.0), 2147483650.0);
  EXPECT_EQ(unwrapCount(-2147483640.0, 2147483646.0), -2147483650.0);
  EXPECT_EQ(unwrapCount(10.0, 12.0), 12.0);
  EXPECT_EQ(unwrapCount(3 * range + 5, 7.0), 3 * range + 7);
}

TEST(UnwrapCount, FollowsALongRun) {
  Random random(5);
  double truth = 0.0, unwrapped = 0.0;
  for (int k = 0; k < 10000; ++k) {
    truth += std::floor(random.uniform(-4e8, 6e8));
    const auto raw = static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(truth)));
    unwrapped = unwrapCount(unwrapped, raw);
    ASSERT_EQ(unwrapped, truth);
  }
}

}  // namespace
}  // namespace scan_to_path::robot
