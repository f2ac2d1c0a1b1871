// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "fuzz.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/toolpath/ball_tool.h"
#include "scan_to_path/toolpath/contact_frame.h"

using namespace scan_to_path;

std::vector<std::string> fuzz::seeds() {
  toolpath::ToolPath path;
  path.process = "cutting";
  path.frame = "base_link";
  path.T_contact_tcp = toolpath::ballToolFrame({0.02, 0.1, 0.2});
  for (const char* name : {"approach", "row_0", "retract"}) {
    toolpath::Segment segment = {name, {}};
    for (int i = 0; i < 3; ++i) {
      toolpath::Waypoint waypoint;
      waypoint.pose = toolpath::contactFrame({0.1 * i, -0.2, 0.3}, {0.1, 0.2, 1.0}, {1.0, 0.0, 0.0});
      waypoint.feed = 0.02;
      waypoint.process_on = i > 0;
      segment.waypoints.push_back(waypoint);
    }
    path.segments.push_back(segment);
  }
  return {toolpath::formatToolPath(path)};
}

/// Any bytes are an InputError of one line, or a path that can be written and comes back with as many waypoints.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  toolpath::ToolPath path;
  try {
    path = toolpath::parseToolPath(std::string(fuzz::asText(data, size)), "fuzz");
  } catch (const InputError& error) {
    fuzz::require(std::string_view(error.what()).find('\n') == std::string_view::npos, "a message is one line");
    return 0;
  }
  for (const auto& segment : path.segments) {
    fuzz::require(!segment.waypoints.empty(), "a segment has waypoints");
    for (const auto& waypoint : segment.waypoints)
      fuzz::require(waypoint.pose.matrix().allFinite(), "poses are finite");
  }
  const auto again = toolpath::parseToolPath(toolpath::formatToolPath(path), "again");
  fuzz::require(toolpath::waypointCount(again) == toolpath::waypointCount(path), "a path comes back whole");
  return 0;
}
