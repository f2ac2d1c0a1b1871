// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/transform_history.h"

#include <gmock/gmock.h>
#include <tf2/exceptions.h>

#include <limits>

#include "moving_sensor.h"

namespace scan_to_path_ros {
namespace {

using test::MovingSensor;
using Reach = TransformHistory::Reach;

class TransformHistoryTest : public ::testing::Test {
protected:
  void SetUp() override {
    history_.add(MovingSensor::mountTransform(), true);
    for (int i = 0; i <= 10; ++i) history_.add(MovingSensor::linkTransform(0.01 * i), false);
  }
  TransformHistory history_{TransformHistoryOptions()};
};

TEST_F(TransformHistoryTest, InterpolatesToTheStamp) {
  for (const double t : {0.0, 0.003, 0.05, 0.0999, 0.1}) {
    ASSERT_EQ(history_.reach(MovingSensor::stamp(t)), Reach::known) << t;
    const auto T = MovingSensor::linkAt(t) * MovingSensor::mount();
    // Both ends are doubles near 1 m: some ten roundings of 1e-16.
    EXPECT_LT((history_.sensorAt(MovingSensor::stamp(t)).matrix() - T.matrix()).norm(), 1e-14) << t;
  }
}

TEST_F(TransformHistoryTest, NeverReachesBeyondItsEnds) {
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.1001)), Reach::not_yet);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(-0.0001)), Reach::before_first);
}

TEST_F(TransformHistoryTest, TellsAGap) {
  history_.add(MovingSensor::linkTransform(0.16), false);  // 60 ms after the last, the limit is 50
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.13)), Reach::gap);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.16)), Reach::known);
  history_.add(MovingSensor::linkTransform(0.13), false);  // came late, and out of order
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.14)), Reach::known);
}

TEST_F(TransformHistoryTest, TracksTheSensorFromTheScanOn) {
  history_.add(MovingSensor::linkTransform(0.6), false);  // the robot waited for half a second
  for (int i = 61; i <= 70; ++i) history_.add(MovingSensor::linkTransform(0.01 * i), false);
  for (int i = 600; i <= 695; ++i) EXPECT_EQ(history_.reach(MovingSensor::stamp(0.001 * i)), Reach::known) << i;
  history_.follow(MovingSensor::stamp(0.65));
  history_.add(MovingSensor::linkTransform(0.655), false);  // late
  history_.follow(MovingSensor::stamp(0.695));
  ASSERT_EQ(history_.track().size(), 11U);
  EXPECT_NEAR(history_.track().timeOf(6), 0.055, 1e-9);
  EXPECT_NEAR(history_.track().timeOf(10), 0.09, 1e-9);
  const auto place = MovingSensor::linkAt(0.6) * MovingSensor::mount();
  EXPECT_LT((history_.track().valuesOf(0).head<3>() - place.translation()).norm(), 1e-12);
}

TEST_F(TransformHistoryTest, TellsAJumpOfPlaceOrDirection) {
  // 2 m/s over 10 ms allow 20 mm.
  auto moved = MovingSensor::linkTransform(0.11);
  moved.transform.translation.x += 0.021;
  history_.add(moved, false);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.105)), Reach::jump);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.095)), Reach::known);
  auto back = moved;
  back.header.stamp = MovingSensor::stamp(0.12);
  back.transform.translation.x -= 0.018;  // within what the speed allows
  history_.add(back, false);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.115)), Reach::known);
  const auto turned = Eigen::AngleAxisd(1.5707963267948966, Eigen::Vector3d::UnitY()) *
                      tf2::transformToEigen(back).rotation();  // the point ahead moves by more than 0.14 m
  auto tilted = back;
  tilted.header.stamp = MovingSensor::stamp(0.13);
  tilted.transform.rotation = tf2::toMsg(Eigen::Quaterniond(turned));
  history_.add(tilted, false);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.125)), Reach::jump);
}

TEST_F(TransformHistoryTest, ForgetsWhatWasWhenTheClockGoesBack) {
  EXPECT_TRUE(history_.add(MovingSensor::linkTransform(-0.5), false).isZero());  // disorder, within 1 s
  EXPECT_DOUBLE_EQ(history_.add(MovingSensor::linkTransform(-5.0), false).toSec(), 5.1);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.05)), Reach::not_yet);
  EXPECT_TRUE(history_.add(MovingSensor::linkTransform(-4.99), false).isZero());
  ASSERT_EQ(history_.reach(MovingSensor::stamp(-4.995)), Reach::known);
  EXPECT_NO_THROW(history_.sensorAt(MovingSensor::stamp(-4.995)));  // the mount is still there
}

TEST_F(TransformHistoryTest, TakesNoTransformThatIsNotFinite) {
  auto broken = MovingSensor::linkTransform(0.11);
  broken.transform.translation.y = std::numeric_limits<double>::quiet_NaN();
  history_.add(broken, false);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.105)), Reach::not_yet);
  broken = MovingSensor::linkTransform(0.12);
  broken.transform.rotation.w = std::numeric_limits<double>::infinity();
  history_.add(broken, false);
  EXPECT_EQ(history_.reach(MovingSensor::stamp(0.105)), Reach::not_yet);
}

TEST(TransformHistory, KeepsNoMoreThanItsCache) {
  TransformHistoryOptions options;
  options.cache = 0.05;
  TransformHistory history(options);
  history.add(MovingSensor::mountTransform(), true);
  for (int i = 0; i <= 20; ++i) history.add(MovingSensor::linkTransform(0.01 * i), false);
  EXPECT_EQ(history.reach(MovingSensor::stamp(0.1)), Reach::before_first);
  EXPECT_EQ(history.reach(MovingSensor::stamp(0.16)), Reach::known);
}

TEST(TransformHistory, WaitsForFramesThatAreMissing) {
  TransformHistory history{TransformHistoryOptions()};
  for (int i = 0; i <= 10; ++i) history.add(MovingSensor::linkTransform(0.01 * i), false);
  EXPECT_EQ(history.reach(MovingSensor::stamp(0.05)), Reach::not_yet);  // no mount yet
  EXPECT_THROW(history.sensorAt(MovingSensor::stamp(0.05)), tf2::TransformException);
  history.add(MovingSensor::mountTransform(), true);
  EXPECT_EQ(history.reach(MovingSensor::stamp(0.05)), Reach::known);
}

}  // namespace
}  // namespace scan_to_path_ros
