// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rapid_text.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/angles.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/program/rapid_names.h"

namespace scan_to_path::program {
namespace {

constexpr std::size_t line_width = 80;

std::string list(std::initializer_list<std::string> items) {
  std::string text = "[";
  for (const auto& item : items) text += (text.size() > 1 ? "," : "") + item;
  return text + "]";
}

void appendSafetyNotice(std::string& module) {
  appendComment(module, "SAFETY. This program was generated; nobody has run it yet.");
  appendComment(module, "- Collisions of arm, tool, cables and cell are NOT checked.");
  appendComment(module, "- Simulate it first (RobotStudio with this robot, this tool, this work object).");
  appendComment(module,
                "- Then drive it dry: generate it with dry_offset, process off, and run it in manual reduced "
                "speed with the enabling device in hand.");
  appendComment(module, "- Then run it on the part at reduced speed override before full speed.");
  appendComment(module, "- Check tool data, load data and work object against the cell; identify the load.");
  appendComment(module,
                "- Whoever loads and starts it is responsible for the risk assessment of the cell and for "
                "the people in it. See docs/programs.md.");
}

}  // namespace

std::string rapidNumber(double value, int digits) {
  if (!std::isfinite(value)) throw InputError("robot program: number is not finite");
  return fixed(value, digits);
}

std::string rapidPosition(const geometry::Vector3& position) {
  return list(
      {rapidNumber(1e3 * position.x(), 4), rapidNumber(1e3 * position.y(), 4), rapidNumber(1e3 * position.z(), 4)});
}

std::string rapidOrientation(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q = geometry::canonicalQuaternion(R);
  return list({rapidNumber(q.w(), 8), rapidNumber(q.x(), 8), rapidNumber(q.y(), 8), rapidNumber(q.z(), 8)});
}

std::string rapidAxes(const JointVector& axes) {
  std::string text;
  for (int i = 0; i < axes.size(); ++i) text += (i > 0 ? "," : "[") + rapidNumber(degrees_per_radian * axes[i], 6);
  return text + "]";
}

std::string rapidConfiguration(const AxisConfiguration& configuration) {
  return list({std::to_string(configuration.cf1), std::to_string(configuration.cf4), std::to_string(configuration.cf6),
               std::to_string(configuration.cfx)});
}

void appendComment(std::string& module, std::string_view text) {
  constexpr std::string_view lead = "  ! ";
  std::string rest = asciiLine(text);
  std::string indent;
  do {
    std::size_t length = line_width - lead.size() - indent.size();
    if (rest.size() > length) {
      const std::size_t blank = rest.rfind(' ', length);
      if (blank != std::string::npos && blank > 0) length = blank;
    }
    module.append(lead).append(indent).append(rest, 0, length).append("\n");
    rest.erase(0, std::min(rest.size(), length));
    rest.erase(0, std::min(rest.size(), rest.find_first_not_of(' ')));
    indent = "  ";
  } while (!rest.empty());
}

void appendHeader(std::string& module, const ProgramInput& input, std::size_t moves) {
  appendComment(module, "scan_to_path: " + input.path.process + " for " + input.robot.name);
  appendSafetyNotice(module);
  for (const auto& line : input.notices) appendComment(module, line);
  for (const auto& line : input.provenance) appendComment(module, line);
  for (const auto& line : input.options.comments) appendComment(module, line);
  appendComment(module,
                std::to_string(moves) + " waypoints in " + std::to_string(input.path.segments.size()) + " segments");
  if (input.options.dry_offset > 0.0) {
    appendComment(module, "AIR RUN: the whole path is shifted by " + rapidNumber(1e3 * input.options.dry_offset, 3) +
                              " mm, its targets and its start; the process stays off.");
  }
  appendComment(module, "Units: mm, degrees, mm/s, kg; quaternions w, x, y, z. Targets: tool centre point " +
                            input.options.tool_name + " in " + input.options.workobject_name +
                            ", whose user frame is given in the world frame, taken to be the robot's base.");
}

}  // namespace scan_to_path::program
