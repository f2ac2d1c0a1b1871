// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/cell.h"

#include <gmock/gmock.h>

#include <fstream>

#include "scan_to_path/common/error.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::HasSubstr;

const std::vector<std::filesystem::path> shipped = {SCAN_TO_PATH_SOURCE_DIR};

std::string cellError(const CellOptions& options) {
  try {
    makeCell(options, shipped);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The shipped arm with one of its links renamed, in a file of its own.
std::string armWithLink(const std::string& name) {
  std::ifstream file(std::string(SCAN_TO_PATH_SOURCE_DIR) + "/urdf/irb2400.urdf");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  for (auto at = text.find("\"link_5\""); at != std::string::npos; at = text.find("\"link_5\"", at)) {
    text.replace(at, 8, "\"" + name + "\"");
  }
  const std::string path = ::testing::TempDir() + "/arm_with_" + name + ".urdf";
  std::ofstream(path) << text;
  return path;
}

TEST(Cell, MountsTurnedByDegreesAreRefused) {
  for (MountOptions CellOptions::*mount : {&CellOptions::sensor, &CellOptions::tool, &CellOptions::workpiece}) {
    CellOptions options;
    (options.*mount).rpy = {0.0, 2.0 * M_PI, -M_PI};
    EXPECT_EQ(cellError(options), "no error");
    (options.*mount).rpy.x() = 45.0;
    EXPECT_THAT(cellError(options), HasSubstr(".rpy[0] is 45 rad, must be in [-7, 7]"));
  }
}

TEST(Cell, DefaultsMakeTheShippedCell) {
  const Cell cell = makeCell(CellOptions(), shipped);
  EXPECT_EQ(cell.robot.dof(), 6);
  EXPECT_EQ(cell.T_tip_tcp.translation(), CellOptions().tool.xyz);
}

TEST(Cell, TheShippedArmHasItsLinkage) {
  const Cell cell = makeCell(CellOptions(), shipped);
  ASSERT_TRUE(cell.robot.coupled_axis);
  EXPECT_EQ(cell.robot.coupled_axis->joints, (std::vector<int>{1, 2}));
  std::vector<double> counts(6, 0.0);
  counts[1] = 131072.0 * 100.0 / 8.0;  // the motor of axis 2 alone: the elbow gives way
  EXPECT_NEAR(cell.encoders.angles(counts.data())[2], -M_PI / 4.0, 1e-12);
  CellOptions options;
  options.axis_coupling.axis.clear();
  EXPECT_FALSE(makeCell(options, shipped).robot.coupled_axis);
}

TEST(Cell, AnotherArmMustSayWhatItsControllerCouples) {
  std::ifstream file(std::string(SCAN_TO_PATH_SOURCE_DIR) + "/urdf/irb2400.urdf");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string name = "<robot name=\"irb2400\"";
  text.replace(text.find(name), name.size(), "<robot name=\"irb4600\"");
  CellOptions options;
  options.robot = ::testing::TempDir() + "/irb4600.urdf";
  std::ofstream(options.robot) << text;
  EXPECT_THAT(cellError(options), HasSubstr("cell.axis_coupling is said of robot irb2400, not of irb4600: set"));
  options.axis_coupling.axis.clear();
  EXPECT_EQ(cellError(options), "no error");
}

TEST(Cell, ValuesForOtherJointsThanTheChainsNameTheChain) {
  CellOptions options;
  options.base_link = "link_1";
  options.axis_coupling.axis.clear();
  EXPECT_EQ(cellError(options),
            "encoders.counts_per_turn: number of values is 6, must be 5: the chain from link_1 to tool0 has 5 joints");
}

TEST(Cell, PackageAddressesAreLookedUp) {
  const std::filesystem::path parent = ::testing::TempDir() + "/packages";
  std::filesystem::create_directories(parent / "some_robot/urdf");
  std::ofstream(parent / "some_robot/urdf/arm.urdf") << "x";
  EXPECT_EQ(resolveFile("package://some_robot/urdf/arm.urdf", {"/nowhere", parent}),
            parent / "some_robot/urdf/arm.urdf");
  EXPECT_EQ(resolveFile("package://some_robot/urdf/arm.urdf", {parent / "some_robot"}),
            parent / "some_robot/urdf/arm.urdf");
  std::filesystem::create_directories(parent / "checkout");
  std::ofstream(parent / "checkout/package.xml") << "<package><name>named_robot</name></package>";
  std::ofstream(parent / "checkout/arm.urdf") << "x";
  EXPECT_EQ(resolveFile("package://named_robot/arm.urdf", {parent / "checkout"}), parent / "checkout/arm.urdf");
  EXPECT_EQ(resolveFile("arm.urdf", {}), "arm.urdf");
  EXPECT_THROW(resolveFile("package://other/urdf/arm.urdf", {parent}), InputError);
}

TEST(Cell, MountsMustBeOnFlangeAndBase) {
  CellOptions options;
  options.sensor.parent = "link_3";
  EXPECT_EQ(cellError(options), "cell.sensor: parent is 'link_3', must be 'tool0'");
  options = CellOptions();
  options.workpiece.parent = "tool0";
  EXPECT_EQ(cellError(options), "cell.workpiece: parent is 'tool0', must be 'base_link'");
}

TEST(Cell, LinksMustNotTakeTheCellsOwnFrames) {
  for (const char* name : {"sensor", "tcp", "workpiece"}) {
    CellOptions options;
    options.robot = armWithLink(name);
    EXPECT_THAT(cellError(options), HasSubstr(std::string("has a link called '") + name + "'"));
  }
}

TEST(Cell, BadNumbersAreNamed) {
  CellOptions options;
  options.tool.xyz.z() = std::nan("");
  EXPECT_THAT(cellError(options), HasSubstr("cell.tool.xyz[2] is nan m"));
  options = CellOptions();
  options.laser.voltage_max = options.laser.voltage_min;
  EXPECT_THAT(cellError(options), HasSubstr("voltage"));
  options = CellOptions();
  options.robot = "package://scan_to_path/urdf/none.urdf";
  EXPECT_THAT(cellError(options), HasSubstr("cannot find package://scan_to_path/urdf/none.urdf"));
}

}  // namespace
}  // namespace scan_to_path::pipeline
