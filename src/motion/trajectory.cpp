// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/trajectory.h"

#include <cmath>
#include <functional>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/quote.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::motion {

namespace {

using AppendJoints = std::function<void(std::string&, const JointVector&)>;

std::string format(const Trajectory& trajectory, const AppendJoints& append_joints) {
  std::string text = "t,segment,index";
  for (const std::string& name : trajectory.joint_names) text += "," + name;
  text += '\n';
  for (const TrajectoryPoint& point : trajectory.points) {
    appendFixed(text, point.time, 6);
    text += ',';
    appendInteger(text, point.segment);
    text += ',';
    appendInteger(text, point.index);
    append_joints(text, point.q);
    text += '\n';
  }
  return text;
}

double number(std::string_view cell, const std::string& where, const std::string& quantity) {
  double value = 0.0;
  if (!parseNumber(trimmed(cell), value) || !std::isfinite(value)) {
    throw InputError(where, quantity, inQuotes(trimmed(cell)), "a finite number");
  }
  return value;
}

int wholeNumber(std::string_view cell, const std::string& where, const std::string& quantity) {
  const double value = number(cell, where, quantity);
  constexpr double largest = 2147483647.0;
  if (!(value >= 0.0 && value <= largest && value == std::floor(value))) {
    throw InputError(where, quantity, std::string(trimmed(cell)), "a whole number >= 0");
  }
  return static_cast<int>(value);
}

std::vector<std::string> parseHeader(std::string_view line, const std::string& where) {
  constexpr std::size_t leading = 3, max_joints = 8;
  const auto cells = split(trimmed(line), ',');
  if (cells.size() <= leading || cells.size() > leading + max_joints || cells[0] != "t" || cells[1] != "segment" ||
      cells[2] != "index") {
    throw InputError(where + ": header must be t,segment,index and one to eight joint names");
  }
  return {cells.begin() + leading, cells.end()};
}

TrajectoryPoint parsePoint(std::string_view line, const std::vector<std::string>& joints, const std::string& where) {
  const auto cells = split(line, ',');
  if (cells.size() != joints.size() + 3) {
    throw InputError(where, "number of cells", std::to_string(cells.size()), std::to_string(joints.size() + 3));
  }
  TrajectoryPoint point;
  point.time = number(cells[0], where, "t");
  point.segment = wholeNumber(cells[1], where, "segment");
  point.index = wholeNumber(cells[2], where, "index");
  point.q.resize(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    point.q[static_cast<Eigen::Index>(i)] = number(cells[i + 3], where, joints[i]);
  }
  return point;
}

}  // namespace

std::string formatTrajectory(const Trajectory& trajectory) {
  return format(trajectory, [](std::string& text, const JointVector& q) {
    for (const double angle : q) {
      text += ',';
      appendFixed(text, angle, 9);
    }
  });
}

std::string formatPulses(const Trajectory& trajectory, const robot::Encoders& encoders) {
  return format(trajectory, [&encoders](std::string& text, const JointVector& q) {
    for (const double count : encoders.counts(q)) {
      text += ',';
      appendFixed(text, std::nearbyint(count), 0);
    }
  });
}

Trajectory parseTrajectory(const std::string& text, const std::string& name) {
  Trajectory trajectory;
  const auto lines = split(text, '\n');
  trajectory.joint_names = parseHeader(lines.front(), name + " line 1");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (trimmed(lines[i]).empty() && i + 1 == lines.size()) break;
    const std::string where = name + " line " + std::to_string(i + 1);
    const TrajectoryPoint point = parsePoint(lines[i], trajectory.joint_names, where);
    if (!trajectory.points.empty() && !(point.time > trajectory.points.back().time)) {
      throw InputError(where, "t", fixed(point.time, 6) + " s",
                       "after " + fixed(trajectory.points.back().time, 6) + " s");
    }
    trajectory.points.push_back(point);
  }
  return trajectory;
}

Trajectory parsePulses(const std::string& text, const std::string& name, const robot::Encoders& encoders) {
  Trajectory trajectory = parseTrajectory(text, name);
  for (TrajectoryPoint& point : trajectory.points) point.q = encoders.angles(point.q.data());
  return trajectory;
}

}  // namespace scan_to_path::motion
