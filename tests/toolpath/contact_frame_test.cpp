// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/contact_frame.h"

#include <gtest/gtest.h>

#include "support/expect_input_error.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

namespace scan_to_path::toolpath {
namespace {

TEST(ContactFrame, IsRightHandedWithZOnTheNormalAndXTowardsTheFeed) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 point = test::randomVector(random, 1.0);
    const Vector3 normal = random.uniform(0.1, 10.0) * test::randomDirection(random);
    const Vector3 feed = random.uniform(0.1, 10.0) * test::randomDirection(random);
    if (normal.cross(feed).norm() < 1e-3 * normal.norm() * feed.norm()) continue;
    const Frame T = contactFrame(point, normal, feed);
    // Rounding of a few unit operations, enlarged a thousandfold where feed and normal are nearly parallel.
    const double tolerance = 1e-12;
    EXPECT_NEAR(T.linear().determinant(), 1.0, tolerance);
    EXPECT_LT((T.linear().transpose() * T.linear() - Eigen::Matrix3d::Identity()).norm(), tolerance);
    EXPECT_LT((T.linear().col(2) - normal.normalized()).norm(), tolerance);
    EXPECT_GT(T.linear().col(0).dot(feed), 0.0);
    EXPECT_NEAR(T.linear().col(1).dot(feed) / feed.norm(), 0.0, tolerance);
    EXPECT_EQ(T.translation(), point);
  }
}

TEST(ContactFrame, MovesWithItsInput) {
  Random random(2);
  const Vector3 point(0.1, 0.2, 0.3);
  const Vector3 normal(0.1, -0.2, 1.0);
  const Vector3 feed(1.0, 0.3, 0.1);
  for (int i = 0; i < 100; ++i) {
    const Frame T = test::randomFrame(random);
    const Frame moved = contactFrame(T * point, T.linear() * normal, T.linear() * feed);
    EXPECT_LT((moved.matrix() - (T * contactFrame(point, normal, feed)).matrix()).norm(), 1e-14 * 30);
  }
}

TEST(ContactFrame, RejectsDirectionsThatDefineNone) {
  const Vector3 z = Vector3::UnitZ();
  test::expectInputError([&] { contactFrame(Vector3::Zero(), Vector3::Zero(), z); }, "normal");
  test::expectInputError([&] { contactFrame(Vector3::Zero(), z, Vector3::Zero()); }, "feed direction");
  test::expectInputError([&] { contactFrame(Vector3::Zero(), z, -2.0 * z); }, "parallel");
  test::expectInputError([&] { contactFrame(Vector3(std::nan(""), 0, 0), z, Vector3::UnitX()); }, "not finite");
}

TEST(ContactFrame, TellsContactsAndRowsApart) {
  Segment row = test::planeRows(1, 0.0, 0.1, 2).segments[0];
  EXPECT_TRUE(isRow(row));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(isContact(row, i)) << i;
  Waypoint air = row.waypoints[0];
  row.waypoints.insert(row.waypoints.begin(), air);
  row.waypoints.push_back(air);
  EXPECT_FALSE(isContact(row, 0));
  EXPECT_TRUE(isContact(row, 1));
  EXPECT_FALSE(isContact(row, 4));
  EXPECT_FALSE(isRow({"approach", {air, air}}));
}

}  // namespace
}  // namespace scan_to_path::toolpath
