// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::toolpath {

using geometry::Frame;

/// A contact frame on the surface and how the tool gets there.
struct Waypoint {
  Frame pose = Frame::Identity();  ///< contact frame: origin on the surface, z outward normal, x feed direction
  double feed = 0.0;               ///< of the move to this waypoint [m/s]
  bool process_on = false;         ///< true while the tool works on the move to this waypoint
  double arc_length = 0.0;         ///< from the segment's first waypoint [m]
};

/// A waypoint by its place in a path.
struct WaypointIndex {
  int segment = 0;  ///< index into the path's segments
  int index = 0;    ///< index into the segment's waypoints

  bool operator<(const WaypointIndex& other) const {
    return segment != other.segment ? segment < other.segment : index < other.index;
  }
};

/// Waypoints that are driven without a stop: one row with its lead-in and lead-out, an approach, a link.
struct Segment {
  std::string name;  ///< e.g. "row_3", "approach", "link_3_4"
  std::vector<Waypoint> waypoints;
};

struct ToolPath {
  std::string process;                      ///< "cutting", …
  std::string frame;                        ///< the frame of every pose, e.g. "base_link"
  Frame T_contact_tcp = Frame::Identity();  ///< tool centre point in the contact frame, constant along the path
  geometry::Vector3 lift =
      geometry::Vector3::Zero();  ///< of an air run off the part [m], in `frame`; zero: on the part
  std::vector<Segment> segments;
};

std::size_t waypointCount(const ToolPath& path);

/// Where a segment's contact frames stand, in order [m].
std::vector<geometry::Vector3> positionsOf(const Segment& segment);

/// How far the contact travels, over all moves of a path.
struct Travel {
  double worked = 0.0;  ///< with the process on [m]
  double length = 0.0;  ///< [m]
  double time = 0.0;    ///< at the feeds, without ramps [s]
};

Travel travelOf(const ToolPath& path);

/// Fills every segment's arc_length from its poses.
ToolPath withArcLength(ToolPath path);

/// The path with every rotation snapped (geometry::snapped): what a file or message gives back is what is driven, but
/// for positions, which path.csv rounds to 1e-9 m.
ToolPath snapped(ToolPath path);

/// path.csv as docs/file_formats.md has it: comments with frame, T_contact_tcp and, of an air run, the lift, then
/// `segment,index,x,y,z,qx,qy,qz,qw,feed,process_on` (m, m/s; 1e-9 m and 1e-12 in the quaternion).
std::string formatToolPath(const ToolPath& path);

/// The inverse of formatToolPath. Throws InputError with the line number.
ToolPath parseToolPath(const std::string& text, const std::string& name);

}  // namespace scan_to_path::toolpath
