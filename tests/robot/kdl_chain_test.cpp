// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/kdl_chain.h"

#include <gtest/gtest.h>

#include <kdl/chainfksolverpos_recursive.hpp>

#include "support/irb2400.h"

namespace scan_to_path::robot {
namespace {

constexpr double chain_rounding = 1e-14;  // a dozen products of numbers about 1

Frame kdlForward(const Robot& robot, const JointVector& q) {
  KDL::JntArray angles(static_cast<unsigned>(robot.dof()));
  angles.data = q;
  KDL::Frame T;
  const KDL::Chain chain = kdlChain(robot);  // the solver keeps a reference to it
  KDL::ChainFkSolverPos_recursive(chain).JntToCart(angles, T);
  return fromKdl(T);
}

TEST(KdlChain, MovesAsTheDenavitHartenbergProduct) {
  const Robot robot = test::irb2400();
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    const JointVector q = test::randomJoints(robot, random);
    EXPECT_TRUE(kdlForward(robot, q).isApprox(test::denavitHartenberg(q.data()), 100 * chain_rounding)) << "case " << k;
  }
}

TEST(KdlChain, SeesAFlippedAxis) {
  Robot robot = test::irb2400();
  robot.joints[2].axis *= -1.0;
  Random random(5);
  const JointVector q = test::randomJoints(robot, random);
  EXPECT_FALSE(kdlForward(robot, q).isApprox(test::denavitHartenberg(q.data()), 1e-3));
}

TEST(KdlChain, FramesGoThereAndBack) {
  const Frame T = geometry::makeFrame({0.1, -0.2, 0.3}, {0.4, -0.5, 0.6});
  EXPECT_TRUE(fromKdl(toKdl(T)).isApprox(T, chain_rounding));
}

}  // namespace
}  // namespace scan_to_path::robot
