// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scan_to_path/common/random.h"
#include "support/surface_oracle.h"

namespace scan_to_path::geometry {
namespace {

Eigen::Matrix3d randomRotation(Random& random) { return test::randomFrame(random).linear(); }

TEST(Frames, RollPitchYawTurnAboutFixedAxesInThatOrder) {
  // URDF: a quarter roll takes y to z, then a quarter yaw takes x to y.
  const Frame T = makeFrame({1, 2, 3}, {M_PI / 2, 0, M_PI / 2});
  EXPECT_LT((T * Vector3(1, 0, 0) - Vector3(1, 3, 3)).norm(), 1e-15);
  EXPECT_LT((T * Vector3(0, 1, 0) - Vector3(1, 2, 4)).norm(), 1e-15);
  EXPECT_LT((T * Vector3(0, 0, 1) - Vector3(2, 2, 3)).norm(), 1e-15);
}

TEST(Frames, FrameFromAxesIsRightHandedWithTheGivenZ) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vector3 z = test::randomDirection(random);
    const Vector3 hint = test::randomDirection(random);
    const Frame T = frameFromAxes({1, 2, 3}, z, hint);
    // Orthogonalising loses digits when the hint is nearly parallel to z.
    const double tolerance = 4e-16 / z.cross(hint).norm();
    EXPECT_NEAR((T.linear().transpose() * T.linear() - Eigen::Matrix3d::Identity()).norm(), 0.0, 10 * tolerance);
    EXPECT_NEAR(T.linear().determinant(), 1.0, 10 * tolerance);
    EXPECT_EQ(T.linear().col(2), z);
    EXPECT_GT(T.linear().col(0).dot(hint), 0.0);
    EXPECT_NEAR(T.linear().col(1).dot(hint), 0.0, 10 * tolerance);
  }
}

TEST(Frames, CanonicalQuaternionIsTheSameForBothSigns) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3d R = randomRotation(random);
    const Eigen::Quaterniond q = canonicalQuaternion(R);
    EXPECT_GE(q.w(), 0.0);
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
    EXPECT_LT((q.toRotationMatrix() - R).norm(), 1e-14);
  }
}

TEST(Frames, CanonicalQuaternionOfHalfTurnsIsPositive) {
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Matrix3d R = 2.0 * Vector3::Unit(axis) * Vector3::Unit(axis).transpose() - Eigen::Matrix3d::Identity();
    EXPECT_EQ(canonicalQuaternion(R).vec(), Vector3::Unit(axis));
    EXPECT_EQ(canonicalQuaternion(R).w(), 0.0);
  }
}

/// What a reader of a file with 12 digits, or of a message, makes of a rotation.
Eigen::Matrix3d readBack(const Eigen::Matrix3d& R, bool twelve_digits) {
  Eigen::Vector4d c = canonicalQuaternion(R).coeffs();
  if (twelve_digits) c = (c * 1e12).array().round() / 1e12;
  return Eigen::Quaterniond(c).normalized().toRotationMatrix();
}

/// Rotations at random, half turns, and those with components that are equal but for the last bit.
std::vector<Frame> rotationsOfAllKinds() {
  Random random(3);
  std::vector<Frame> frames;
  for (int i = 0; i < 20000; ++i) frames.push_back(test::randomFrame(random));
  for (const double roll : {0.0, M_PI / 2, M_PI, -M_PI / 2, 1e-12}) {
    for (const double pitch : {0.0, M_PI / 2, 0.3}) {
      for (const double yaw : {0.0, M_PI / 2, M_PI, 2.0 * M_PI / 3.0})
        frames.push_back(makeFrame({1, 2, 3}, {roll, pitch, yaw}));
    }
  }
  return frames;
}

TEST(Frames, SnappedRotationsComeBackToTheLastBit) {
  std::size_t changed_without = 0;
  for (const Frame& T : rotationsOfAllKinds()) {
    const Frame S = snapped(T);
    // Half a step in each of three components, and in the fourth what unit length makes of it.
    EXPECT_LT(rotationAngle(S.linear(), T.linear()), 1e-11);
    EXPECT_EQ(S.translation(), T.translation());
    for (const bool twelve_digits : {false, true}) {
      Frame read = S;
      read.linear() = readBack(S.linear(), twelve_digits);
      EXPECT_TRUE(snapped(read).matrix() == S.matrix()) << T.matrix();
    }
    if (readBack(T.linear(), false) != T.linear()) ++changed_without;
  }
  EXPECT_GT(changed_without, 1000u) << "the test's rotations would come back without being snapped";
}

TEST(Frames, RoundedDirectionsDoNotDependOnTheOrderOfTheSum) {
  Random random(4);
  std::vector<Vector3> directions;
  const Vector3 mean = test::randomDirection(random);
  for (int i = 0; i < 20000; ++i) directions.push_back((mean + 0.1 * test::randomDirection(random)).normalized());
  Vector3 up = Vector3::Zero();
  for (const auto& direction : directions) up += direction;
  Vector3 down = Vector3::Zero();
  for (auto direction = directions.rbegin(); direction != directions.rend(); ++direction) down += *direction;
  EXPECT_NE(up.normalized(), down.normalized()) << "the test's sums would be the same anyway";
  EXPECT_EQ(roundedDirection(up), roundedDirection(down));
  EXPECT_LT(angleBetween(roundedDirection(up), up), 1e-9);  // half a step in each of three components
  EXPECT_NEAR(roundedDirection(up).norm(), 1.0, 1e-15);
}

TEST(Frames, AnglesAreExactWhenSmallAndWhenLarge) {
  for (const double angle : {0.0, 1e-12, 1e-6, 0.5, M_PI / 2, M_PI - 1e-9, M_PI}) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Vector3(1, 2, 2) / 3).toRotationMatrix();
    // A rotation matrix holds its entries to 1e-16, which is what is left of any angle.
    EXPECT_NEAR(rotationAngle(Eigen::Matrix3d::Identity(), R), angle, 3e-16 + 1e-15 * angle);
    const Vector3 a(std::cos(angle), std::sin(angle), 0);
    EXPECT_NEAR(angleBetween(3 * Vector3::UnitX(), 7 * a), angle, 3e-16 + 1e-15 * angle);
  }
}

TEST(Frames, RotationAngleDoesNotDependOnTheFrame) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d R = randomRotation(random);
    const Eigen::Matrix3d A = randomRotation(random);
    const Eigen::Matrix3d B = randomRotation(random);
    EXPECT_NEAR(rotationAngle(R * A, R * B), rotationAngle(A, B), 1e-14);
    EXPECT_NEAR(rotationAngle(A, B), rotationAngle(B, A), 1e-14);
  }
}

TEST(Frames, AnyOrthogonalIsAUnitVectorAcross) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Vector3 direction = test::randomDirection(random);
    const Vector3 across = anyOrthogonal(direction);
    EXPECT_NEAR(across.norm(), 1.0, 1e-15);
    EXPECT_NEAR(across.dot(direction), 0.0, 1e-15);
  }
}

}  // namespace
}  // namespace scan_to_path::geometry
