// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "fuzz.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/motion/trajectory.h"

using namespace scan_to_path;

std::vector<std::string> fuzz::seeds() {
  motion::Trajectory trajectory;
  trajectory.joint_names = {"joint_1", "joint_2"};
  for (int i = 0; i < 4; ++i)
    trajectory.points.push_back({0.1 * i, i / 2, i % 2, robot::JointVector::Constant(2, -0.3 * i)});
  return {motion::formatTrajectory(trajectory)};
}

/// Any bytes are an InputError of one line, or a trajectory with finite, rising times and finite angles.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  motion::Trajectory trajectory;
  try {
    trajectory = motion::parseTrajectory(std::string(fuzz::asText(data, size)), "fuzz");
  } catch (const InputError& error) {
    fuzz::require(std::string_view(error.what()).find('\n') == std::string_view::npos, "a message is one line");
    return 0;
  }
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    fuzz::require(trajectory.points[i].q.allFinite(), "angles are finite");
    fuzz::require(i == 0 || trajectory.points[i].time > trajectory.points[i - 1].time, "times rise");
  }
  return 0;
}
