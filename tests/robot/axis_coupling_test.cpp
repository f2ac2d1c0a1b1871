// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/axis_coupling.h"

#include <gmock/gmock.h>

#include "support/expect_input_error.h"
#include "support/irb2400.h"

namespace scan_to_path::robot {
namespace {

TEST(CoupledAxis, DefaultIsTheShippedArms) {
  const auto coupled = coupledAxis(AxisCouplingOptions(), test::irb2400());
  ASSERT_TRUE(coupled);
  EXPECT_EQ(coupled->axis, 2);
  EXPECT_EQ(coupled->joints, (std::vector<int>{1, 2}));
  EXPECT_NEAR(coupled->lower, -60.0 * M_PI / 180.0, 1e-15);
  EXPECT_NEAR(coupled->upper, 65.0 * M_PI / 180.0, 1e-15);
}

TEST(CoupledAxis, NothingIsDeclaredByAnEmptyAxis) {
  AxisCouplingOptions options;
  options.axis.clear();
  options.robot = "another";
  EXPECT_FALSE(coupledAxis(options, test::irb2400()));
}

// An IRB 4600 has joints of the same names and no parallelogram: nothing is taken over silently, whatever the case.
TEST(CoupledAxis, IsOfOneRobotOnly) {
  for (const char* name : {"irb4600", "IRB2400", "abb_irb2400"}) {
    Robot robot = test::irb2400();
    robot.name = name;
    test::expectInputError([&] { coupledAxis(AxisCouplingOptions(), robot); },
                           std::string("cell.axis_coupling is said of robot irb2400, not of ") + name);
    AxisCouplingOptions options;
    options.robot = name;
    EXPECT_TRUE(coupledAxis(options, robot));
  }
}

TEST(CoupledAxis, MustFitTheChain) {
  const auto refused = [](const std::string& message, auto&& change) {
    AxisCouplingOptions options;
    change(options);
    test::expectInputError([&] { coupledAxis(options, test::irb2400()); }, message);
  };
  using Options = AxisCouplingOptions;
  refused("cell.axis_coupling.axis: robot irb2400 has no joint joint_33, did you mean joint_3?",
          [](Options& o) { o.axis = "joint_33"; });
  refused("cell.axis_coupling.joints: robot irb2400 has no joint elbow", [](Options& o) { o.joints[0] = "elbow"; });
  refused("joint_2 stands twice", [](Options& o) { o.joints.push_back("joint_2"); });
  refused("at least two, joint_3 (axis) among them", [](Options& o) { o.joints = {"joint_3"}; });
  refused("at least two, joint_3 (axis) among them", [](Options& o) { o.joints = {"joint_1", "joint_2"}; });
  refused("upper is -2.000000 rad, must be > lower", [](Options& o) { o.upper = -2.0; });
  refused("cell.axis_coupling.lower is nan rad", [](Options& o) { o.lower = std::nan(""); });
}

}  // namespace
}  // namespace scan_to_path::robot
