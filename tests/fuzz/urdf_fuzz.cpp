// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "fuzz.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/robot/robot.h"
#include "support/urdfdom_leaks.h"

using namespace scan_to_path;

std::vector<std::string> fuzz::seeds() {
  const std::string limit = "<limit lower='-1' upper='2' velocity='3' effort='0'/>";
  return {
      "<?xml version='1.0'?><robot name='r'><material name='m'><color rgba='1 0 0 1'/></material>"
      "<link name='base_link'><visual><geometry><box size='1 1 1'/></geometry><material name='m'/></visual></link>"
      "<link name='a'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>"
      "</inertial></link><link name='b'><collision><geometry><cylinder radius='1' length='2'/></geometry>"
      "</collision></link><link name='tool0'/>"
      "<joint name='j1' type='revolute'><parent link='base_link'/><child link='a'/><axis xyz='0 0 1'/>"
      "<origin xyz='0.1 0 0' rpy='0 1 0'/>" +
      limit + "</joint><joint name='j2' type='continuous'><parent link='a'/><child link='b'/>" + limit +
      "</joint><joint name='f' type='fixed'><parent link='b'/><child link='tool0'/></joint></robot>"};
}

/// Any bytes are an InputError of one line, or a chain with finite frames, unit axes and limits in order.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  robot::Robot robot;
  try {
    robot = robot::parseRobot(std::string(fuzz::asText(data, size)), "base_link", "tool0");
  } catch (const InputError& error) {
    fuzz::require(std::string_view(error.what()).find('\n') == std::string_view::npos, "a message is one line");
    return 0;
  }
  fuzz::require(robot.dof() >= 1 && robot.dof() <= 8, "a chain has one to eight joints");
  for (const robot::Joint& joint : robot.joints) {
    fuzz::require(joint.lower < joint.upper && joint.max_velocity > 0.0, "limits are in order");
    fuzz::require(std::abs(joint.axis.norm() - 1.0) < 1e-12, "axes are unit vectors");
  }
  const robot::JointVector q = robot::JointVector::Zero(robot.dof());
  fuzz::require(robot::forwardKinematics(robot, q).matrix().allFinite(), "poses are finite");
  return 0;
}
