// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/axis_configuration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "program_cases.h"
#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

using test::degree;
using test::joints;

TEST(AxisQuadrant, CountsQuartersFromZeroInBothDirections) {
  // ABB's technical reference manual, confdata: quadrant 0 is 0 to 90 degrees, 1 is 90 to 180, -1 is 0 to -90, …
  const double angles[] = {-370, -359, -269, -179, -91, -89, -1, 0, 1, 45, 89, 91, 179, 181, 271, 361, 399};
  const int quadrants[] = {-5, -4, -3, -2, -2, -1, -1, 0, 0, 0, 0, 1, 1, 2, 3, 4, 4};
  for (std::size_t i = 0; i < std::size(angles); ++i) {
    EXPECT_EQ(axisQuadrant(degree * angles[i]), quadrants[i]) << angles[i];
  }
}

TEST(AxisQuadrant, RoundingDoesNotDecideOnABoundary) {
  EXPECT_EQ(axisQuadrant(-0.0), 0);
  EXPECT_EQ(axisQuadrant(-1e-12), 0);
  EXPECT_EQ(axisQuadrant(1e-12), 0);
  for (int k = -4; k <= 4; ++k) {
    const double boundary = k * M_PI_2;
    EXPECT_EQ(axisQuadrant(std::nextafter(boundary, -10.0)), k);
    EXPECT_EQ(axisQuadrant(std::nextafter(boundary, 10.0)), k);
  }
  EXPECT_EQ(axisQuadrant(-1e-6), -1);
}

// The eight rows of ABB's table, wrist centre worked out by hand for the IRB 2400 (shoulder 0.1 m before axis 1, lower
// arm 0.705 m, from the elbow 0.135 m up and 0.755 m forward to the wrist centre), seen from the shoulder, x forward
// and z up, at the angles of axes 2 and 3:
//   0, 0:     elbow (0, 0.705), wrist (0.755, 0.840): before axis 1, before the lower arm.
//   0, -100:  forearm tipped up 100 degrees to (-0.264, 0.720); wrist (-0.264, 1.425): 0.164 m behind axis 1, and
//             behind the lower arm, which is vertical.
//   30, -100: the same turned forward by 30 degrees: wrist (0.484, 1.366), before axis 1, still behind the lower arm.
//   -90, 0:   all turned back by 90 degrees: elbow (-0.705, 0), wrist (-0.840, 0.755): behind axis 1, and on the same
//             side of the lower arm as at 0, 0: before it.
TEST(AxisConfiguration, CfxFollowsAbbTable) {
  const struct {
    double axis_2, axis_3, axis_5;
    int cfx;
  } rows[] = {{0, 0, 20, 0},   {0, 0, -20, 1},   {30, -100, 20, 2}, {30, -100, -20, 3},
              {-90, 0, 20, 4}, {-90, 0, -20, 5}, {0, -100, 20, 6},  {0, -100, -20, 7}};
  for (const auto& row : rows) {
    for (const double axis_1 : {-170.0, -60.0, 0.0, 100.0}) {
      const auto found =
          axisConfiguration(test::irb2400(), joints({axis_1, row.axis_2, row.axis_3, 10, row.axis_5, 0}));
      EXPECT_EQ(found.cfx, row.cfx) << axis_1 << " " << row.axis_2 << " " << row.axis_3 << " " << row.axis_5;
    }
  }
}

TEST(AxisConfiguration, QuadrantsComeFromAxesOneFourAndSix) {
  const auto found = axisConfiguration(test::irb2400(), joints({-100, 10, 20, 95, 30, -200}));
  EXPECT_EQ(found.cf1, -2);
  EXPECT_EQ(found.cf4, 1);
  EXPECT_EQ(found.cf6, -3);
  EXPECT_EQ(found.cfx, 0);
}

TEST(AxisConfiguration, RefusesAnotherNumberOfJoints) {
  auto robot = test::irb2400();
  robot.joints.pop_back();
  test::expectInputError([&] { axisConfiguration(robot, joints({0, 0, 0, 0, 0})); }, "must be 6");
  test::expectInputError([&] { axisConfiguration(test::irb2400(), joints({0, 0, 0, 0, 0})); }, "must be 6");
}

// With the lower arm turned and axis 3 of the controller held, the forearm keeps its slope: what a parallelogram does.
TEST(ControllerAxes, ForearmKeepsItsSlopeAtConstantAxisThree) {
  const auto at = [](double axis_2) {
    const auto q = joints({0, axis_2, 15.0 - axis_2, 0, 0, 0});
    EXPECT_NEAR(robot::controllerAxes(test::irb2400WithLinkage(), q)[2], 15 * degree, 1e-15);
    return robot::forwardKinematics(test::irb2400(), q).linear().eval();
  };
  EXPECT_LT((at(-20) - at(40)).norm(), 1e-14);
}

}  // namespace
}  // namespace scan_to_path::program
