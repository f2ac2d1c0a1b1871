// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/driven_feed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scan_to_path/common/random.h"
#include "support/irb2400.h"

namespace scan_to_path::motion {
namespace {

/// joint_4, which may turn at 0.9 * 2 pi = 5.6549 rad/s, turns by 100 rad per metre: 0.056549 m/s can be driven.
class DrivenFeedTest : public testing::Test {
protected:
  DrivenFeedTest() {
    arrival_ = {{}, JointVector::Zero(6), JointVector::Zero(6), 0.0, true};
    arrival_.rate[3] = 100.0;
  }

  double at(double asked) {
    arrival_.feed = asked;
    return drivenFeed(robot_, arrival_, options_);
  }

  robot::Robot robot_ = scan_to_path::test::irb2400();
  MotionOptions options_;
  Arrival arrival_;
};

TEST_F(DrivenFeedTest, IsTheFeedAskedForWhereNoJointIsTooFast) {
  EXPECT_EQ(at(0.0123456789), 0.0123456789);
  EXPECT_EQ(at(0.0565), 0.0565);
}

TEST_F(DrivenFeedTest, GoesDownInStepsByHand) {
  EXPECT_DOUBLE_EQ(at(0.0566), 0.053770);  // 0.95
  EXPECT_DOUBLE_EQ(at(0.06), 0.05415);     // 0.057 is too fast, 0.95^2
  EXPECT_DOUBLE_EQ(at(0.2), 0.055477);     // 0.95^24 gives 0.058398, 0.95^25 0.0554780 less rounding
}

TEST_F(DrivenFeedTest, EndsAtTheLeastShare) {
  // 0.95^26 = 0.26352, 0.95^27 = 0.25034, 0.95^28 = 0.23783: the last step is the least share itself.
  EXPECT_DOUBLE_EQ(at(0.22596), 0.056490);  // 0.2503 of it could be driven: 0.25
  EXPECT_EQ(at(0.2264), 0.2264);            // 0.2498: less than may be
  options_.least_feed_share = 0.1;
  EXPECT_NEAR(at(0.2264), 0.2264 * std::pow(0.95, 28), 1e-6);
  options_.least_feed_share = 1.0;
  EXPECT_EQ(at(0.0566), 0.0566);
  options_.least_feed_share = 0.0;
  EXPECT_NEAR(at(50.0), 50.0 * std::pow(0.95, 133), 1e-6);  // 0.056549 / 50 lies between 0.95^133 and 0.95^132
  arrival_.rate[3] = 1e9;
  EXPECT_EQ(at(50.0), 50.0) << "slower than a program can say";
}

TEST_F(DrivenFeedTest, MovesInTheAirAreLeftAsTheyAre) {
  arrival_.process_on = false;
  EXPECT_EQ(at(0.2), 0.2);
}

// Over random rates: no joint is too fast, no more than a step and a digit are given away, a program says it exactly,
// and all of them are few. A step of 10 % would break the second.
TEST_F(DrivenFeedTest, IsCloseToWhatTheJointsCanDo) {
  Random random(3);
  std::set<double> feeds;
  int lowered = 0;
  for (int i = 0; i < 2000; ++i) {
    for (int j = 0; j < 6; ++j) arrival_.rate[j] = random.uniform(0.0, 200.0);
    double fastest = 0.1;
    for (int j = 0; j < 6; ++j) {
      fastest = std::min(fastest, 0.9 * robot_.joints[static_cast<std::size_t>(j)].max_velocity / arrival_.rate[j]);
    }
    const double feed = at(0.1);
    if (fastest < 0.025) {
      ASSERT_EQ(feed, 0.1) << fastest;
      continue;
    }
    feeds.insert(feed);
    lowered += feed < 0.1 ? 1 : 0;
    ASSERT_LE(feed, fastest * (1.0 + 1e-12));
    ASSERT_GE(feed, 0.95 * fastest - 1e-6);
    ASSERT_NEAR(feed * 1e6, std::round(feed * 1e6), 1e-9);
  }
  EXPECT_GT(lowered, 150);
  EXPECT_LE(feeds.size(), 28U);
}

}  // namespace
}  // namespace scan_to_path::motion
