// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "scan_to_path/toolpath/row_selection.h"
#include "scan_to_path/toolpath/tool_path.h"
#include "scan_to_path/toolpath/verdict.h"

/// What there is to draw of a tool path, before any scene graph: the same input, the same lines.
namespace scan_to_path_ros {

namespace core = scan_to_path;

struct PathDrawingOptions {
  core::toolpath::RowSelection rows = core::toolpath::RowSelection::all();
  bool links = true;                ///< draw what is no row: approaches, links, retracts
  double arrow_interval = 0.05;     ///< along a segment [m]; 0: no arrows
  double arrow_size = 0.004;        ///< [m]
  double frame_interval = 0.0;      ///< along a segment [m]; 0: no frames
  std::size_t strip_points = 1024;  ///< a longer strip goes on in the next one; at least 2, rviz takes up to 16384
};

/// Moves in a row that look alike; it starts where the one before it ended.
struct PathStrip {
  bool process_on = false;
  core::toolpath::Verdict verdict = core::toolpath::Verdict::ok;  ///< worse end of each of the moves
  std::vector<core::geometry::Vector3> points;
};

/// A waypoint that is not ok.
struct PathMark {
  core::geometry::Vector3 point = core::geometry::Vector3::Zero();
  core::toolpath::Verdict verdict = core::toolpath::Verdict::ok;
};

/// In the frame of the path, metres.
struct PathDrawing {
  std::vector<PathStrip> strips;
  std::vector<std::array<core::geometry::Vector3, 3>> arrows;  ///< wing, tip, wing: the tip points where the tool goes
  std::vector<core::geometry::Frame> frames;                   ///< contact frames
  std::vector<PathMark> marks;

  std::size_t rows = 0;  ///< segments that are rows or pieces of rows
  std::size_t rows_shown = 0;
  std::size_t segments = 0;
  std::size_t waypoints = 0;
  double length_on = 0.0;   ///< of all moves with the tool at work, shown or not [m]
  double length_off = 0.0;  ///< of all others [m]
  std::array<std::size_t, core::EnumNames<core::toolpath::Verdict>::names.size()> verdicts = {};  ///< waypoints of each
};

/// A waypoint without a verdict is ok. Throws InputError for a verdict on a waypoint that the path does not have, and
/// for fewer than two points a strip.
PathDrawing drawPath(const core::toolpath::ToolPath& path, const std::vector<core::toolpath::WaypointVerdict>& verdicts,
                     const PathDrawingOptions& options);

/// What a person wants to know of it at a glance: "41 rows, 83 segments, 9120 waypoints; 8.21 m on, 1.33 m off".
std::string describePath(const PathDrawing& drawing);
/// "9120 ok" or "9117 ok, 3 gouge".
std::string describeVerdicts(const PathDrawing& drawing);

}  // namespace scan_to_path_ros
