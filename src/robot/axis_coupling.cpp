// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/axis_coupling.h"

#include <algorithm>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::robot {
namespace {

const std::string section = "cell.axis_coupling";

int jointIndex(const Robot& robot, const std::string& name, const std::string& key) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) names.push_back(joint.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  throw InputError(section + "." + key + ": robot " + robot.name + " has no joint " + name + ", did you mean " +
                   nearestWord(name, names) + "?");
}

}  // namespace

std::optional<CoupledAxis> coupledAxis(const AxisCouplingOptions& options, const Robot& robot) {
  validate(options, section);
  if (options.axis.empty()) return std::nullopt;
  if (options.robot != robot.name) {
    throw InputError(section + " is said of robot " + options.robot + ", not of " + robot.name + ": set " + section +
                     ".axis to nothing when its controller counts every joint by itself, else " + section +
                     ".robot, axis, joints, lower and upper");
  }
  CoupledAxis coupled;
  coupled.axis = jointIndex(robot, options.axis, "axis");
  coupled.lower = options.lower;
  coupled.upper = options.upper;
  for (const std::string& name : options.joints) {
    const int joint = jointIndex(robot, name, "joints");
    if (std::find(coupled.joints.begin(), coupled.joints.end(), joint) != coupled.joints.end()) {
      throw InputError(section + ".joints: " + name + " stands twice");
    }
    coupled.joints.push_back(joint);
  }
  if (coupled.joints.size() < 2 ||
      std::find(coupled.joints.begin(), coupled.joints.end(), coupled.axis) == coupled.joints.end()) {
    throw InputError(section + ".joints must be at least two, " + options.axis + " (axis) among them");
  }
  if (!(coupled.lower < coupled.upper)) {
    throw InputError(section, "upper", fixed(coupled.upper, 6) + " rad",
                     "> lower, " + fixed(coupled.lower, 6) + " rad");
  }
  return coupled;
}

}  // namespace scan_to_path::robot
