// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/inverse_kinematics.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <ctime>

#include "support/irb2400.h"

namespace scan_to_path::robot {
namespace {

using geometry::rotationAngle;
using test::denavitHartenberg;
using test::irb2400;
using test::randomJoints;

double largestDifference(const JointVector& a, const JointVector& b) { return (a - b).cwiseAbs().maxCoeff(); }

void expectReaches(const JointVector& q, const Frame& T_base_tip) {
  const Frame T = denavitHartenberg(q.data());
  ASSERT_LE((T.translation() - T_base_tip.translation()).norm(), 1e-7);
  ASSERT_LE(rotationAngle(T.linear(), T_base_tip.linear()), 1e-7);
}

/// Smallest singular value of the Jacobian: how far from singular, in mixed units of m and rad.
double smallestSingularValue(const Robot& robot, const JointVector& q) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(Eigen::MatrixXd(jacobian(robot, q))).singularValues().minCoeff();
}

TEST(InverseKinematics, ReturnsToWhereItWasFromNearby) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  Random random(1);
  for (int k = 0; k < 5000; ++k) {
    const JointVector q = randomJoints(robot, random);
    const double sigma = smallestSingularValue(robot, q);
    if (sigma < 0.02) continue;
    JointVector seed = q;
    for (int i = 0; i < 6; ++i) seed[i] += random.uniform(-1, 1) * 0.1 * sigma;
    const auto found = inverse.solve(forwardKinematics(robot, q), seed);
    ASSERT_TRUE(found) << "case " << k;
    // The residual allowed by the solver, 1e-10, divided by the smallest singular value, both for m and for rad.
    ASSERT_LT(largestDifference(*found, q), 2e-10 / sigma);
  }
}

TEST(InverseKinematics, ColdAnswersReachThePoseByDenavitHartenberg) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  Random random(2);
  int solved = 0;
  for (int k = 0; k < 2000; ++k) {
    const Frame T = denavitHartenberg(randomJoints(robot, random).data());
    const auto found = inverse.solve(T, JointVector::Zero(6));
    if (!found) continue;
    ++solved;
    expectReaches(*found, T);
  }
  EXPECT_EQ(solved, 2000);
}

TEST(InverseKinematics, TakesTheWholeTurnNearestToTheSeed) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  JointVector q(6);
  q << 0.3, 0.2, 0.1, 0.4, 0.7, 0.5;
  const Frame T = forwardKinematics(robot, q);
  for (int turns = -3; turns <= 3; ++turns) {
    JointVector expected = q;
    expected[5] += turns * 2.0 * M_PI;
    const auto found = inverse.solve(T, expected + JointVector::Constant(6, 0.01));
    ASSERT_TRUE(found);
    EXPECT_LT(largestDifference(*found, expected), 1e-8);
  }
}

TEST(InverseKinematics, SolvesInAndNearTheWristSingularity) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  for (const double bend : {0.0, 1e-9, 1e-6, 1e-3}) {
    JointVector q(6);
    q << 0.3, 0.2, 0.1, 0.4, bend, 0.5;
    const Frame T = forwardKinematics(robot, q);
    const auto found = inverse.solve(T, q + JointVector::Constant(6, 1e-3));
    ASSERT_TRUE(found) << bend;
    expectReaches(*found, T);
  }
}

TEST(InverseKinematics, OutOfReachIsNothingAndQuick) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  const std::clock_t begin = std::clock();  // processor time: other processes do not count
  int tried = 0;
  for (const double distance : {1.75, 1.8, 2.0, 2.3, 5.0, 1e6}) {
    for (const double height : {0.0, 0.6, 2.0}) {
      Frame T = Frame::Identity();
      T.translation() = Vector3(distance, 0.1, height);
      EXPECT_FALSE(inverse.solve(T, JointVector::Zero(6)));
      EXPECT_TRUE(inverse.allConfigurations(T).empty());
      ++tried;
    }
  }
  const double elapsed = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_LT(elapsed / tried, 0.5);  // 0.01 s in Release; room for sanitizers
}

TEST(InverseKinematics, PosesThatAreNotFiniteHaveNoSolution) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  Frame T = Frame::Identity();
  T.translation() = Vector3(0.9, NAN, 0.5);
  EXPECT_FALSE(inverse.solve(T, JointVector::Zero(6)));
  EXPECT_TRUE(inverse.allConfigurations(T).empty());
  T.translation().setZero();
  T.linear()(1, 1) = NAN;
  EXPECT_FALSE(inverse.solve(T, JointVector::Zero(6)));
}

TEST(InverseKinematics, MovingTheBaseMovesNothingElse) {
  Robot robot = irb2400();
  JointVector q(6);
  q << 0.3, 0.2, 0.1, 0.4, 0.7, 0.5;
  const Frame T = forwardKinematics(robot, q);
  const Frame T_world_base = geometry::makeFrame({1, 2, 3}, {0.1, 0.2, 0.3});
  robot.joints[0].T_parent_joint = T_world_base * robot.joints[0].T_parent_joint;
  const auto found = InverseKinematics(robot).solve(T_world_base * T, q + JointVector::Constant(6, 0.05));
  ASSERT_TRUE(found);
  EXPECT_LT(largestDifference(*found, q), 1e-8);
}

TEST(AllConfigurations, AreWithinLimitsDistinctSortedAndReachThePose) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    const Frame T = denavitHartenberg(randomJoints(robot, random).data());
    const auto all = inverse.allConfigurations(T);
    ASSERT_FALSE(all.empty());
    for (std::size_t i = 0; i < all.size(); ++i) {
      expectReaches(all[i], T);
      EXPECT_GE(limitMargin(robot, all[i]), 0.0);
      for (std::size_t j = 0; j < i; ++j) EXPECT_GT(largestDifference(all[i], all[j]), 1e-6);
    }
    const auto again = inverse.allConfigurations(T);
    ASSERT_EQ(again.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(again[i], all[i]);
  }
}

/// Every solution of the IRB 2400's pose within its limits in closed form: its last three axes meet in a point.
std::vector<JointVector> closedForm(const Robot& robot, const Frame& T) {
  constexpr double a1 = 0.100, b = 0.135, c1 = 0.615, c2 = 0.705, c3 = 0.755, c4 = 0.085;
  const Vector3 wrist = T.translation() - c4 * T.linear().col(2);
  const double forearm = std::hypot(c3, b), bend = std::atan2(b, c3);
  std::vector<JointVector> solutions;
  for (const double shoulder : {0.0, M_PI}) {
    const double q1 = std::atan2(wrist.y(), wrist.x()) + shoulder;
    const double x = (shoulder == 0.0 ? 1.0 : -1.0) * std::hypot(wrist.x(), wrist.y()) - a1, z = wrist.z() - c1;
    const double cosine = (x * x + z * z - c2 * c2 - forearm * forearm) / (2 * c2 * forearm);
    if (std::abs(cosine) > 1.0) continue;
    for (const double elbow : {1.0, -1.0}) {
      const double turned = elbow * std::acos(cosine);  // from the lower to the upper arm, downwards
      const double q2 = std::atan2(x, z) - std::atan2(forearm * std::sin(turned), c2 + forearm * std::cos(turned));
      const double q3 = turned - M_PI_2 + bend;
      JointVector q(6);
      q << q1, q2, q3, 0, 0, 0;
      const Eigen::Matrix3d R = denavitHartenberg(q.data()).linear().transpose() * T.linear();
      // R = Rz(q4) Ry(q5) Rz(q6) in the flange's axes at q4 = q5 = q6 = 0.
      for (const double flip : {1.0, -1.0}) {
        q[4] = flip * std::atan2(std::hypot(R(0, 2), R(1, 2)), R(2, 2));
        q[3] = std::atan2(flip * R(1, 2), flip * R(0, 2));
        q[5] = std::atan2(flip * R(2, 1), -flip * R(2, 0));
        for (int turns = 0; turns < 729; ++turns) {
          JointVector variant = q;
          for (int i = 0, digits = turns; i < 6; ++i, digits /= 3) variant[i] += 2.0 * M_PI * (digits % 3 - 1);
          if (limitMargin(robot, variant) >= 0.0) solutions.push_back(variant);
        }
      }
    }
  }
  return solutions;
}

bool contains(const std::vector<JointVector>& list, const JointVector& q) {
  return std::any_of(list.begin(), list.end(),
                     [&q](const JointVector& other) { return largestDifference(q, other) < 1e-5; });
}

/// Share of random reachable poses for which `all` has exactly what the closed form has.
double completeShare(const Robot& robot, int poses, const std::function<std::vector<JointVector>(const Frame&)>& all) {
  Random random(4);
  int complete = 0;
  for (int k = 0; k < poses; ++k) {
    const JointVector q = randomJoints(robot, random);
    const Frame T = denavitHartenberg(q.data());
    const auto expected = closedForm(robot, T), found = all(T);
    EXPECT_TRUE(contains(expected, q)) << "the oracle misses " << q.transpose();
    if (std::all_of(expected.begin(), expected.end(), [&](const JointVector& e) { return contains(found, e); }))
      ++complete;
    EXPECT_TRUE(std::all_of(found.begin(), found.end(), [&](const JointVector& f) { return contains(expected, f); }));
  }
  return static_cast<double>(complete) / poses;
}

#ifdef __SANITIZE_ADDRESS__
constexpr int compared_poses = 100;  // fifty times slower there
#else
constexpr int compared_poses = 1000;
#endif

TEST(AllConfigurations, AreAllThatTheClosedFormHas) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  EXPECT_GE(completeShare(robot, compared_poses, [&](const Frame& T) { return inverse.allConfigurations(T); }), 0.99);
}

// The same list without those that the controller would refuse; the closed form knows nothing of axis 3.
TEST(AllConfigurations, KeepToTheCoupledAxis) {
  const Robot serial = irb2400(), coupled = test::irb2400WithLinkage();
  const InverseKinematics all(serial), allowed(coupled);
  Random random(9);
  std::size_t kept = 0, refused = 0;
  for (int k = 0; k < 100; ++k) {
    const Frame T = denavitHartenberg(randomJoints(serial, random).data());
    std::vector<JointVector> expected;
    for (const JointVector& q : all.allConfigurations(T)) {
      const double axis_3 = (q[1] + q[2]) * 180.0 / M_PI;
      if (axis_3 >= -60.0 && axis_3 <= 65.0)
        expected.push_back(q);
      else
        ++refused;
    }
    kept += expected.size();
    EXPECT_EQ(allowed.allConfigurations(T), expected);
  }
  EXPECT_GT(kept, 50u);
  EXPECT_GT(refused, 50u);
}

TEST(AllConfigurations, CompletenessCheckSeesALostConfiguration) {
  const Robot robot = irb2400();
  const InverseKinematics inverse(robot);
  EXPECT_LT(completeShare(robot, 50,
                          [&](const Frame& T) {
                            auto all = inverse.allConfigurations(T);
                            all.pop_back();
                            return all;
                          }),
            0.99);
}

// Fifteen turns in each of six joints are eleven million variants of every configuration.
TEST(AllConfigurations, OfLongRangesAreTheTurnsNearestTheMiddle) {
  Robot robot = irb2400();
  const JointVector q = (JointVector(6) << 0.1, 0.2, -0.3, 0.4, 0.5, 0.6).finished();
  for (Joint& joint : robot.joints) joint.lower = -47.0, joint.upper = 47.0;
  const auto all = InverseKinematics(robot).allConfigurations(forwardKinematics(robot, q));
  ASSERT_FALSE(all.empty());
  EXPECT_LE(all.size(), 8U * 256U);
  for (const JointVector& found : all) expectReaches(found, forwardKinematics(robot, q));
  // Without a turn is nearest the middle.
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&q](const auto& a) { return largestDifference(a, q) < 1e-5; }));
  // One wrist that turns for long has all its turns: 15 of them within 47 rad, for each of the flips.
  robot = irb2400();
  robot.joints[5].lower = -47.0, robot.joints[5].upper = 47.0;
  const auto turned = InverseKinematics(robot).allConfigurations(forwardKinematics(robot, q));
  const auto same = std::count_if(turned.begin(), turned.end(), [&q](const JointVector& a) {
    return largestDifference(a.head(5), q.head(5)) < 1e-5;
  });
  EXPECT_EQ(same, 15);
}

TEST(AllConfigurations, OfAContinuousWristHaveOneTurnEach) {
  Robot robot = irb2400();
  robot.joints[5].lower = -std::numeric_limits<double>::infinity();
  robot.joints[5].upper = std::numeric_limits<double>::infinity();
  JointVector q(6);
  q << 0.3, 0.2, 0.1, 0.4, 0.7, 0.5;
  const auto all = InverseKinematics(robot).allConfigurations(forwardKinematics(robot, q));
  EXPECT_TRUE(contains(all, q));
  for (const JointVector& other : all) EXPECT_LE(std::abs(other[5]), M_PI);
}

}  // namespace
}  // namespace scan_to_path::robot
