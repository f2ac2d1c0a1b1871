// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/path_drawing.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path_ros {
namespace {

using core::geometry::Vector3;
using core::toolpath::Segment;
using core::toolpath::Verdict;

using SegmentVerdicts = std::vector<Verdict>;

/// One verdict for each waypoint.
std::vector<SegmentVerdicts> spread(const core::toolpath::ToolPath& path,
                                    const std::vector<core::toolpath::WaypointVerdict>& verdicts) {
  std::vector<SegmentVerdicts> spread;
  for (const auto& segment : path.segments) spread.emplace_back(segment.waypoints.size(), Verdict::ok);
  for (const auto& entry : verdicts) {
    const auto segment = static_cast<std::size_t>(entry.segment);
    const auto index = static_cast<std::size_t>(entry.index);
    if (entry.segment < 0 || segment >= spread.size() || entry.index < 0 || index >= spread[segment].size()) {
      throw core::InputError("verdict on waypoint " + std::to_string(entry.index) + " of segment " +
                             std::to_string(entry.segment) + ", which the path does not have");
    }
    spread[segment][index] = entry.verdict;
  }
  return spread;
}

/// A move is as bad as the waypoint it leads to or, that being ok, the one it comes from: a lone bad waypoint shows.
Verdict ofMove(const SegmentVerdicts& verdicts, std::size_t to) {
  return verdicts[to] != Verdict::ok ? verdicts[to] : verdicts[to - 1];
}

void addStrips(PathDrawing& drawing, const Segment& segment, const SegmentVerdicts& verdicts, std::size_t most) {
  PathStrip* strip = nullptr;
  for (std::size_t i = 1; i < segment.waypoints.size(); ++i) {
    const auto& to = segment.waypoints[i];
    const Verdict verdict = ofMove(verdicts, i);
    if (strip == nullptr || strip->process_on != to.process_on || strip->verdict != verdict ||
        strip->points.size() == most) {
      drawing.strips.push_back({to.process_on, verdict, {segment.waypoints[i - 1].pose.translation()}});
      strip = &drawing.strips.back();
    }
    strip->points.push_back(to.pose.translation());
  }
}

void addMarks(PathDrawing& drawing, const Segment& segment, const SegmentVerdicts& verdicts) {
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i] != Verdict::ok) drawing.marks.push_back({segment.waypoints[i].pose.translation(), verdicts[i]});
  }
}

/// Length of the way to each waypoint [m].
std::vector<double> wayTo(const Segment& segment) {
  std::vector<double> way(segment.waypoints.size(), 0.0);
  for (std::size_t i = 1; i < way.size(); ++i) {
    way[i] =
        way[i - 1] + (segment.waypoints[i].pose.translation() - segment.waypoints[i - 1].pose.translation()).norm();
  }
  return way;
}

/// Flat on the surface, half a size before and behind `middle`; of a move along the normal, in the plane of z and y.
std::array<Vector3, 3> arrow(const Vector3& middle, const Vector3& travel, const core::geometry::Frame& pose,
                             double size) {
  constexpr double half_width = 0.35;  // of the size
  constexpr double along_normal = 0.1;
  Vector3 side = pose.linear().col(2).cross(travel);
  side = side.norm() > along_normal ? side.normalized() : Vector3(pose.linear().col(1));
  const Vector3 back = middle - 0.5 * size * travel;
  return {back + half_width * size * side, middle + 0.5 * size * travel, back - half_width * size * side};
}

/// Evenly along the segment, one at least unless the segment is shorter than an arrow.
void addArrows(PathDrawing& drawing, const Segment& segment, const std::vector<double>& way,
               const PathDrawingOptions& options) {
  if (options.arrow_interval <= 0.0 || way.empty() || way.back() <= options.arrow_size) return;
  const double count = std::max(1.0, std::floor(way.back() / options.arrow_interval));
  for (double k = 0.0; k < count; k += 1.0) {
    const double at = way.back() * (k + 0.5) / count;
    const auto i = static_cast<std::size_t>(std::upper_bound(way.begin(), way.end() - 1, at) - way.begin());
    const auto& to = segment.waypoints[i].pose;
    const Vector3 travel = (to.translation() - segment.waypoints[i - 1].pose.translation()).normalized();
    drawing.arrows.push_back(arrow(to.translation() - (way[i] - at) * travel, travel, to, options.arrow_size));
  }
}

/// The first waypoint's, and the first one's past each interval.
void addFrames(PathDrawing& drawing, const Segment& segment, const std::vector<double>& way, double interval) {
  if (interval <= 0.0) return;
  double next = 0.0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (way[i] < next) continue;
    drawing.frames.push_back(segment.waypoints[i].pose);
    next = (std::floor(way[i] / interval) + 1.0) * interval;
  }
}

void addFigures(PathDrawing& drawing, const Segment& segment, const SegmentVerdicts& verdicts,
                const std::vector<double>& way) {
  drawing.waypoints += way.size();
  for (const Verdict verdict : verdicts) ++drawing.verdicts[static_cast<std::size_t>(verdict)];
  for (std::size_t i = 1; i < way.size(); ++i) {
    (segment.waypoints[i].process_on ? drawing.length_on : drawing.length_off) += way[i] - way[i - 1];
  }
}

}  // namespace

PathDrawing drawPath(const core::toolpath::ToolPath& path, const std::vector<core::toolpath::WaypointVerdict>& verdicts,
                     const PathDrawingOptions& options) {
  if (options.strip_points < 2) throw core::InputError("a strip takes 2 points at least");
  const auto of_waypoints = spread(path, verdicts);
  PathDrawing drawing;
  drawing.segments = path.segments.size();
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const Segment& segment = path.segments[s];
    const auto way = wayTo(segment);
    addFigures(drawing, segment, of_waypoints[s], way);
    const auto row = core::toolpath::rowNumber(segment.name);
    const bool shown = row ? options.rows.contains(*row) : options.links;
    drawing.rows += row ? 1 : 0;
    drawing.rows_shown += row && shown ? 1 : 0;
    if (!shown) continue;
    addStrips(drawing, segment, of_waypoints[s], options.strip_points);
    addMarks(drawing, segment, of_waypoints[s]);
    addArrows(drawing, segment, way, options);
    addFrames(drawing, segment, way, options.frame_interval);
  }
  return drawing;
}

std::string describePath(const PathDrawing& drawing) {
  return std::to_string(drawing.rows) + " rows, " + std::to_string(drawing.segments) + " segments, " +
         std::to_string(drawing.waypoints) + " waypoints; " + core::fixed(drawing.length_on, 2) + " m on, " +
         core::fixed(drawing.length_off, 2) + " m off";
}

std::string describeVerdicts(const PathDrawing& drawing) {
  std::string text;
  for (std::size_t i = 0; i < drawing.verdicts.size(); ++i) {
    if (i > 0 && drawing.verdicts[i] == 0) continue;
    if (i > 0) text += ", ";
    text += std::to_string(drawing.verdicts[i]) + " " + core::EnumNames<Verdict>::names[i];
  }
  return text;
}

}  // namespace scan_to_path_ros
