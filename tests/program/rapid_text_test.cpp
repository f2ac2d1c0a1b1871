// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../../src/program/rapid_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

TEST(RapidText, UnitsAndDigits) {
  EXPECT_EQ(rapidPosition({0.00000004, -1.23456789, 2.0}), "[0.0000,-1234.5679,2000.0000]");
  EXPECT_EQ(rapidPosition({-0.00000004, 0, 0}), "[0.0000,0.0000,0.0000]");
  JointVector q(2);
  q << M_PI, -M_PI / 180.0;
  EXPECT_EQ(rapidAxes(q), "[180.000000,-1.000000]");
  EXPECT_EQ(rapidConfiguration({-1, 0, 2, 5}), "[-1,0,2,5]");
  const Eigen::Matrix3d half_turn = Eigen::AngleAxisd(M_PI, geometry::Vector3::UnitY()).toRotationMatrix();
  EXPECT_EQ(rapidOrientation(half_turn), "[0.00000000,0.00000000,1.00000000,0.00000000]");
}

// RobotWare wants the sum of squares within 1e-5 of 1; four components of 5e-9 are far inside.
TEST(RapidText, QuaternionsAreOfLengthOne) {
  for (int i = 0; i < 100; ++i) {
    const geometry::Vector3 axis(std::sin(i), std::cos(3.0 * i), 0.2);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.1 * i, axis.normalized()).toRotationMatrix();
    double w = 0, x = 0, y = 0, z = 0;
    ASSERT_EQ(std::sscanf(rapidOrientation(R).c_str(), "[%lf,%lf,%lf,%lf]", &w, &x, &y, &z), 4);
    EXPECT_NEAR(w * w + x * x + y * y + z * z, 1.0, 4e-8);
    EXPECT_GE(w, 0.0);
  }
}

TEST(RapidText, NothingUnfiniteIsWritten) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {inf, -inf, std::nan("")}) {
    test::expectInputError([&] { rapidNumber(bad, 3); }, "not finite");
    test::expectInputError([&] { rapidPosition({0, bad, 0}); }, "not finite");
  }
}

TEST(RapidText, CommentsAreWrappedAtBlanks) {
  std::string module;
  appendComment(module, std::string(100, 'x') + " " + std::string(50, 'y') + " " + std::string(50, 'z'));
  appendComment(module, "");
  std::istringstream lines(module);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_LE(line.size(), 80u);
    EXPECT_EQ(line.substr(0, 4), "  ! ");
  }
  EXPECT_EQ(count, 5);  // 76 x, 24 x, y, z, and the empty one
}

}  // namespace
}  // namespace scan_to_path::program
