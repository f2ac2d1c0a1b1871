// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "axis_check.h"

#include <array>
#include <cmath>

#include "scan_to_path/common/angles.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::program {
namespace {

/// Quadrants by their definition: 90 cf <= angle <= 90 (cf + 1) degrees.
void addQuadrants(const RapidMove& move, const JointVector& axes, std::vector<std::string>& found) {
  constexpr std::array<int, 3> joints = {0, 3, 5};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const double lower = right_angle * move.configuration[i];
    const double angle = axes[joints[i]];
    if (angle < lower - 1e-6 || angle > lower + right_angle + 1e-6) {
      found.push_back("quadrant of axis " + std::to_string(joints[i] + 1) + " is " +
                      std::to_string(move.configuration[i]) + " at " + fixed(degrees_per_radian * angle, 3) + " deg");
    }
  }
  const bool negative = move.configuration[3] % 2 != 0;
  if (std::abs(axes[4]) > 1e-6 && negative != (axes[4] < 0.0)) {
    found.push_back("cfx " + std::to_string(move.configuration[3]) + " does not fit axis 5 at " +
                    fixed(degrees_per_radian * axes[4], 3) + " deg");
  }
}

/// What the controller checks by itself: every axis within its own range.
void addRanges(const robot::Robot& robot, const JointVector& axes, std::vector<std::string>& found) {
  for (int i = 0; i < 6; ++i) {
    const auto& joint = robot.joints[static_cast<std::size_t>(i)];
    const auto& coupled = robot.coupled_axis;
    const bool is_coupled = coupled && coupled->axis == i;
    const double lower = is_coupled ? coupled->lower : joint.lower;
    const double upper = is_coupled ? coupled->upper : joint.upper;
    if (axes[i] >= lower && axes[i] <= upper) continue;
    found.push_back("axis " + std::to_string(i + 1) + " would stand at " + fixed(degrees_per_radian * axes[i], 3) +
                    " deg on the controller, limits " + fixed(degrees_per_radian * lower, 1) + " and " +
                    fixed(degrees_per_radian * upper, 1) + " deg");
  }
}

}  // namespace

double otherJoints(const robot::CoupledAxis& coupled, const JointVector& q) {
  double sum = 0.0;
  for (const int joint : coupled.joints) sum += joint == coupled.axis ? 0.0 : q[joint];
  return sum;
}

std::vector<std::string> axisDiscrepancies(const robot::Robot& robot, const RapidMove& move, const JointVector& q) {
  JointVector axes = q;
  if (const auto& coupled = robot.coupled_axis) axes[coupled->axis] += otherJoints(*coupled, q);
  std::vector<std::string> found;
  addQuadrants(move, axes, found);
  addRanges(robot, axes, found);
  return found;
}

}  // namespace scan_to_path::program
