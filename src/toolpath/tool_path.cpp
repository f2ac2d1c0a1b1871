// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/tool_path.h"

#include <array>
#include <cmath>
#include <string_view>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::toolpath {
namespace {

constexpr std::string_view first_line = "# scan_to_path path 1";
constexpr std::string_view header = "segment,index,x,y,z,qx,qy,qz,qw,feed,process_on";
constexpr int length_digits = 9;
constexpr int quaternion_digits = 12;
constexpr int feed_digits = 6;

using PoseNumbers = std::array<double, 7>;  // x, y, z, qx, qy, qz, qw

PoseNumbers numbersOf(const Frame& pose) {
  const Eigen::Quaterniond q = geometry::canonicalQuaternion(pose.linear());
  const auto p = pose.translation();
  return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

void appendPose(std::string& text, const Frame& pose, char separator) {
  const PoseNumbers numbers = numbersOf(pose);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) text += separator;
    appendFixed(text, numbers[i], i < 3 ? length_digits : quaternion_digits);
  }
}

void appendLift(std::string& text, const geometry::Vector3& lift) {
  if (lift.isZero(0.0)) return;
  text += "\n# lift";
  for (int i = 0; i < 3; ++i) {
    text += ' ';
    appendFixed(text, lift[i], length_digits);
  }
}

/// Names stand in a comma-separated file and must come back as they went.
bool isName(std::string_view name) {
  return !name.empty() && name == trimmed(name) && name.find_first_of(",\r\n") == std::string_view::npos;
}

void checkName(const char* what, const std::string& name) {
  if (isName(name)) return;
  throw InputError("tool path: " + std::string(what) + " \"" + name.substr(0, name.find_first_of("\r\n")) +
                   "\" must be a name without commas, line breaks or blanks around it");
}

void checkWritable(const ToolPath& path) {
  checkName("process", path.process);
  checkName("frame", path.frame);
  if (!path.lift.allFinite()) throw InputError("tool path: lift is not finite");
  for (const auto& segment : path.segments) {
    checkName("segment", segment.name);
    if (segment.waypoints.empty()) throw InputError("tool path: segment " + segment.name + " has no waypoints");
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      const auto& waypoint = segment.waypoints[i];
      if (!waypoint.pose.matrix().allFinite() || !std::isfinite(waypoint.feed)) {
        throw InputError("tool path: segment " + segment.name + " waypoint " + std::to_string(i) + " is not finite");
      }
    }
  }
}

/// Reads the lines of a path file and knows where it is, for messages.
class PathReader {
public:
  PathReader(std::string_view text, const std::string& name) : lines_(split(text, '\n')), name_(name) {
    if (!lines_.empty() && lines_.back().empty()) lines_.pop_back();
  }

  ToolPath read() {
    readComments();
    while (next_ < lines_.size()) readRow();
    return withArcLength(std::move(path_));
  }

private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(name_ + " line " + std::to_string(next_) + ": " + message);
  }

  std::string_view takeLine() {
    if (next_ >= lines_.size()) {
      throw InputError(name_ + ": ends after line " + std::to_string(next_) + ", before the header " +
                       std::string(header));
    }
    std::string_view line = lines_[next_++];
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  void readComments() {
    if (takeLine() != first_line) fail("must be \"" + std::string(first_line) + "\"");
    bool has_tcp = false;
    std::string_view line = takeLine();
    for (; !line.empty() && line.front() == '#'; line = takeLine()) {
      std::string_view rest = trimmed(line.substr(1));
      const auto word = rest.substr(0, rest.find(' '));
      rest = trimmed(rest.substr(word.size()));
      if (word == "process") path_.process = rest;
      if (word == "frame") path_.frame = rest;
      if (word == "lift") path_.lift = lift(split(rest, ' '));
      if (word == "T_contact_tcp") {
        path_.T_contact_tcp = pose(split(rest, ' '), 0);
        has_tcp = true;
      }
    }
    if (line != header) fail("must be the header " + std::string(header));
    if (!isName(path_.process)) fail("no comment \"# process …\" before the header");
    if (!isName(path_.frame)) fail("no comment \"# frame …\" before the header");
    if (!has_tcp) fail("no comment \"# T_contact_tcp …\" before the header");
  }

  double number(std::string_view cell, const char* column) const {
    double value = 0.0;
    if (!parseNumber(cell, value) || !std::isfinite(value)) {
      fail(std::string(column) + " is \"" + std::string(cell) + "\", must be a finite number");
    }
    return value;
  }

  geometry::Vector3 lift(const std::vector<std::string_view>& cells) const {
    if (cells.size() != 3) fail("lift must have the three numbers x y z");
    return {number(cells[0], "x"), number(cells[1], "y"), number(cells[2], "z")};
  }

  Frame pose(const std::vector<std::string_view>& cells, std::size_t first) const {
    static constexpr std::array<const char*, 7> columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
    if (cells.size() < first + columns.size()) fail("T_contact_tcp must have the seven numbers x y z qx qy qz qw");
    PoseNumbers n{};
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = number(cells[first + i], columns[i]);
    const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
    if (!(std::abs(q.norm() - 1.0) <= 1e-6)) fail("the quaternion's length must be 1 within 1e-6");
    Frame frame = Frame::Identity();
    frame.linear() = q.normalized().toRotationMatrix();
    frame.translation() = geometry::Vector3(n[0], n[1], n[2]);
    return frame;
  }

  void readRow() {
    const auto cells = split(takeLine(), ',');
    if (cells.size() != 11) fail("has " + std::to_string(cells.size()) + " cells, must have 11");
    if (!isName(cells[0])) fail("the segment has no name, or blanks around it");
    const double index = number(cells[1], "index");
    if (index == 0.0) path_.segments.push_back({std::string(cells[0]), {}});
    if (path_.segments.empty() || path_.segments.back().name != cells[0] ||
        index != static_cast<double>(path_.segments.back().waypoints.size())) {
      fail("index is " + std::string(cells[1]) + ", must count up from 0 in each segment");
    }
    Waypoint waypoint;
    waypoint.pose = pose(cells, 2);
    waypoint.feed = number(cells[9], "feed");
    if (waypoint.feed < 0.0) fail("feed is " + std::string(cells[9]) + " m/s, must be 0 or more");
    if (cells[10] != "0" && cells[10] != "1") fail("process_on is \"" + std::string(cells[10]) + "\", must be 0 or 1");
    waypoint.process_on = cells[10] == "1";
    path_.segments.back().waypoints.push_back(waypoint);
  }

  std::vector<std::string_view> lines_;
  const std::string& name_;
  std::size_t next_ = 0;
  ToolPath path_;
};

}  // namespace

std::size_t waypointCount(const ToolPath& path) {
  std::size_t count = 0;
  for (const auto& segment : path.segments) count += segment.waypoints.size();
  return count;
}

std::vector<geometry::Vector3> positionsOf(const Segment& segment) {
  std::vector<geometry::Vector3> positions;
  positions.reserve(segment.waypoints.size());
  for (const auto& waypoint : segment.waypoints) positions.emplace_back(waypoint.pose.translation());
  return positions;
}

Travel travelOf(const ToolPath& path) {
  Travel travel;
  const Waypoint* before = nullptr;
  for (const Segment& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints) {
      if (before != nullptr) {
        const double length = (waypoint.pose.translation() - before->pose.translation()).norm();
        travel.length += length;
        travel.time += length / waypoint.feed;
        if (waypoint.process_on) travel.worked += length;
      }
      before = &waypoint;
    }
  }
  return travel;
}

ToolPath withArcLength(ToolPath path) {
  for (auto& segment : path.segments) {
    double length = 0.0;
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      auto& waypoint = segment.waypoints[i];
      if (i > 0) length += (waypoint.pose.translation() - segment.waypoints[i - 1].pose.translation()).norm();
      waypoint.arc_length = length;
    }
  }
  return path;
}

ToolPath snapped(ToolPath path) {
  path.T_contact_tcp = geometry::snapped(path.T_contact_tcp);
  for (auto& segment : path.segments) {
    for (auto& waypoint : segment.waypoints) waypoint.pose = geometry::snapped(waypoint.pose);
  }
  return path;
}

std::string formatToolPath(const ToolPath& path) {
  checkWritable(path);
  std::string text;
  text.reserve(160 * waypointCount(path) + 400);
  text.append(first_line).append("\n# process ").append(path.process).append("\n# frame ").append(path.frame);
  text += "\n# T_contact_tcp ";
  appendPose(text, path.T_contact_tcp, ' ');
  appendLift(text, path.lift);
  text.append("\n").append(header).append("\n");
  for (const auto& segment : path.segments) {
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      const auto& waypoint = segment.waypoints[i];
      text.append(segment.name).append(",");
      appendInteger(text, static_cast<std::int64_t>(i));
      text += ',';
      appendPose(text, waypoint.pose, ',');
      text += ',';
      appendFixed(text, waypoint.feed, feed_digits);
      text += waypoint.process_on ? ",1\n" : ",0\n";
    }
  }
  return text;
}

ToolPath parseToolPath(const std::string& text, const std::string& name) { return PathReader(text, name).read(); }

}  // namespace scan_to_path::toolpath
