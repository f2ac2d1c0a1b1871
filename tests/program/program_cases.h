// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "scan_to_path/common/random.h"
#include "scan_to_path/program/program.h"
#include "support/irb2400.h"

namespace scan_to_path::test {

constexpr double degree = 0.017453292519943295;

inline robot::JointVector joints(std::initializer_list<double> degrees) {
  robot::JointVector q(static_cast<int>(degrees.size()));
  int i = 0;
  for (const double value : degrees) q[i++] = degree * value;
  return q;
}

inline geometry::Frame randomFrame(Random& random, double reach) {
  const geometry::Vector3 position(random.uniform(-reach, reach), random.uniform(-reach, reach),
                                   random.uniform(-reach, reach));
  Eigen::Quaterniond q(random.gaussian(), random.gaussian(), random.gaussian(), random.gaussian());
  geometry::Frame T = geometry::Frame::Identity();
  T.linear() = q.normalized().toRotationMatrix();
  T.translation() = position;
  return T;
}

/// Appends a waypoint that the joint angles reach exactly.
inline void addWaypoint(program::ProgramInput& input, const robot::JointVector& q, double feed, bool process_on) {
  const geometry::Frame T_base_tcp = robot::forwardKinematics(input.robot, q) * input.T_tip_tcp;
  const int segment = static_cast<int>(input.path.segments.size()) - 1;
  auto& waypoints = input.path.segments.back().waypoints;
  waypoints.push_back(
      {input.T_base_path.inverse() * T_base_tcp * input.path.T_contact_tcp.inverse(), feed, process_on, 0.0});
  const int index = static_cast<int>(waypoints.size()) - 1;
  input.plan.trajectory.points.push_back({0.0, segment, index, q});
  input.plan.verdicts.push_back({segment, index, toolpath::Verdict::ok, 0.1, "rad", "", ""});
  input.plan.feeds.push_back(feed);
}

/// Rows of smooth joint motion near q0, each with an approach before and a retract after it; frames all different
/// from identity. `waypoints` per row.
inline program::ProgramInput seededInput(std::uint64_t seed, int rows = 3, int waypoints = 40) {
  Random random(seed);
  program::ProgramInput input;
  input.robot = irb2400WithLinkage();
  input.T_base_path = randomFrame(random, 0.3);
  input.T_tip_tcp = randomFrame(random, 0.2);
  input.T_base_workobject = randomFrame(random, 1.0);
  input.path.process = "cutting";
  input.path.frame = "part";
  input.path.T_contact_tcp = randomFrame(random, 0.02);
  input.options.dry_direction = geometry::Vector3(random.gaussian(), random.gaussian(), random.gaussian());
  input.provenance = {"input: samples.csv", "sha256: 0123456789abcdef", "scan_to_path 0.1.0"};
  robot::JointVector q0(6);
  const robot::JointVector amplitude = joints({6, 4, 4, 12, 9, 25});
  q0 << random.uniform(-2.0, 2.0), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-3.0, 3.0),
      random.uniform(-1.5, 1.5), random.uniform(-6.0, 6.0);
  for (int row = 0; row < rows; ++row) {
    const auto at = [&](double s) {
      robot::JointVector q = q0;
      for (int j = 0; j < 6; ++j) q[j] += amplitude[j] * std::sin(1.3 * s + 0.7 * j + 0.2 * row);
      return q;
    };
    input.path.segments.push_back({"approach_" + std::to_string(row), {}});
    for (int i = 0; i < 3; ++i) addWaypoint(input, at(-0.3 + 0.1 * i), 0.2, false);
    input.path.segments.push_back({"row_" + std::to_string(row), {}});
    for (int i = 0; i < waypoints; ++i) {
      const bool on = i >= 2 && i < waypoints - 2;
      addWaypoint(input, at(static_cast<double>(i) / waypoints), on ? 0.03 + 0.01 * row : 0.05, on);
    }
    input.path.segments.push_back({"retract_" + std::to_string(row), {}});
    for (int i = 0; i < 3; ++i) addWaypoint(input, at(1.05 + 0.1 * i), 0.2, false);
  }
  return input;
}

}  // namespace scan_to_path::test
