// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/ball_tool.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/toolpath/contact_frame.h"
#include "support/expect_input_error.h"
#include "support/surface_oracle.h"

namespace scan_to_path::toolpath {
namespace {

constexpr double rounding = 1e-15;

TEST(BallTool, WithoutLeadAndTiltHasItsCentrePointAtTheContact) {
  const Frame T = ballToolFrame({0.02, 0.0, 0.0});
  EXPECT_EQ(T.translation().norm(), 0.0);
  EXPECT_EQ(T.linear().col(2), -Vector3::UnitZ());  // into the work
  EXPECT_EQ(T.linear().col(0), Vector3::UnitX());   // half turn about x
}

TEST(BallTool, KeepsTheBallOnTheContactAtAnyAttitude) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const BallTool tool = {random.uniform(1e-3, 0.05), random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)};
    const Frame contact = test::randomFrame(random);
    const Frame T = contact * ballToolFrame(tool);
    // TCP = c + r z_tool, c = p + r n, rounded at coordinates of about 1 m.
    const Vector3 centre = ballCentre(contact, tool.radius);
    EXPECT_LT((T.translation() - (centre + tool.radius * T.linear().col(2))).norm(), 10.0 * rounding);
    EXPECT_NEAR((centre - contact.translation()).norm(), tool.radius, 10.0 * rounding);
    EXPECT_NEAR(T.linear().determinant(), 1.0, 10.0 * rounding);
  }
}

TEST(BallTool, LeansTheShankTowardsTheFeedByLeadAndToTheRightByTilt) {
  const double angle = 0.3;
  const Vector3 by_lead = -ballToolFrame({0.02, angle, 0.0}).linear().col(2);
  EXPECT_LT((by_lead - Vector3(std::sin(angle), 0.0, std::cos(angle))).norm(), 3.0 * rounding);
  const Vector3 by_tilt = -ballToolFrame({0.02, 0.0, angle}).linear().col(2);
  EXPECT_LT((by_tilt - Vector3(0.0, -std::sin(angle), std::cos(angle))).norm(), 3.0 * rounding);
}

TEST(BallTool, IsThePrintedProductOfTransforms) {
  const double r = 0.013, lead = 0.2, tilt = -0.4;
  const auto about = [](const Vector3& axis, double angle) { return Frame(Eigen::AngleAxisd(angle, axis)); };
  const Frame up(Eigen::Translation3d(0, 0, r));
  const Frame expected =
      up * about(Vector3::UnitY(), lead) * about(Vector3::UnitX(), tilt) * up.inverse() * about(Vector3::UnitX(), M_PI);
  EXPECT_LT((ballToolFrame({r, lead, tilt}).matrix() - expected.matrix()).norm(), 3.0 * rounding);
}

TEST(BallTool, RejectsImpossibleTools) {
  test::expectInputError([] { ballToolFrame({0.0, 0.0, 0.0}); }, "radius is 0.000000 m, must be positive");
  test::expectInputError([] { ballToolFrame({0.02, 1.5, 0.0}); }, "lead");
  test::expectInputError([] { ballToolFrame({0.02, 0.0, std::nan("")}); }, "tilt");
}

}  // namespace
}  // namespace scan_to_path::toolpath
