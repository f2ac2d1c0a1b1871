// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/scan_line_rows.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/curve.h"
#include "scan_to_path/process/row_plan.h"
#include "scan_to_path/scan/normals.h"
#include "scan_to_path/scan/resample.h"

namespace scan_to_path::process {
namespace {

using scan::FittedLine;

constexpr double shortest_piece = 1e-4;  // [m]

/// Parameter at distance `margin` of the line's end, by walking in.
double movedIn(const nurbs::Curve& curve, double from, double to, double margin) {
  if (margin <= 0.0) return from;
  const auto far = [&](double u) { return (nurbs::pointAt(curve, u) - nurbs::pointAt(curve, from)).norm() >= margin; };
  if (!far(to)) return to;
  double near_end = from;
  double far_end = to;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (near_end + far_end);
    (far(middle) ? far_end : near_end) = middle;
  }
  return far_end;
}

FittedLine trimmed(FittedLine line, double margin) {
  const double begin = line.begins_at_edge ? movedIn(line.curve, line.begin, line.end, margin) : line.begin;
  const double end = line.ends_at_edge ? movedIn(line.curve, line.end, line.begin, margin) : line.end;
  line.begin = begin;
  line.end = end;
  return line;
}

double sharpestBend(const FittedLine& line, const std::vector<double>& parameters) {
  double sharpest = 0.0;
  for (const double u : parameters) {
    const nurbs::CurvePoint p = nurbs::evaluate(line.curve, u);
    const double speed = p.first.norm();
    sharpest = std::max(sharpest, p.first.cross(p.second).norm() / (speed * speed * speed));
  }
  return sharpest;
}

/// Parameters that keep the chord within the tolerance at the contact, and at the ball's centre, whose line over a
/// convex bend is 1 + kappa r times as far out.
std::vector<double> waypointParameters(const FittedLine& line, const CuttingOptions& options) {
  scan::ResampleOptions resample{options.max_spacing, options.chord_tolerance};
  const auto coarse = scan::resampleParameters(line, resample);
  resample.chord_error /= 1.0 + options.ball_radius * sharpestBend(line, coarse);
  return scan::resampleParameters(line, resample);
}

std::vector<RowPoint> inScanFrame(const scan::OrientedLine& line, const scan::Frame& T_scan_cloud) {
  std::vector<RowPoint> points;
  for (const auto& p : line.points) {
    const Vector3 point = T_scan_cloud * p.point;
    points.push_back({point.x(), point, T_scan_cloud.linear() * p.normal, T_scan_cloud.linear() * p.tangent});
  }
  return points;
}

bool isLongEnough(const Row& row) {
  return row.points.size() >= 2 && row.points.back().t - row.points.front().t >= shortest_piece;
}

/// Pieces of rows, and the numbers of the rows that there would be without a region.
struct Pieces {
  std::vector<Row> rows;
  std::vector<int> numbers;
};

Pieces piecesOfLines(const scan::FittedScan& scan, const CuttingOptions& options, const toolpath::Region& region) {
  const scan::NormalEstimator estimator(scan, options.normals);
  const scan::Frame T_scan_cloud = scan.T_cloud_scan.inverse();
  Pieces pieces;
  for (std::size_t i = 0; i < scan.lines.size(); ++i) {
    const FittedLine line = trimmed(scan.lines[i], options.edge_margin);
    if (!(line.begin < line.end)) continue;
    const auto pointsOf = [&](const std::vector<double>& parameters) {
      return inScanFrame(estimator.orient(static_cast<int>(i), parameters), T_scan_cloud);
    };
    const auto parameters = waypointParameters(line, options);
    Row row;
    row.row = line.row;
    row.points = pointsOf(parameters);
    if (!isLongEnough(row)) continue;
    if (pieces.numbers.empty() || pieces.numbers.back() != row.row) pieces.numbers.push_back(row.row);
    const auto place = [&](double u) -> Vector3 { return T_scan_cloud * nurbs::pointAt(line.curve, u); };
    for (const auto& stretch : region.inside(place, parameters)) {
      FittedLine part = line;
      part.begin = stretch.begin;
      part.end = stretch.end;
      const bool is_whole = stretch.begin == line.begin && stretch.end == line.end;
      if (!is_whole) row.points = pointsOf(waypointParameters(part, options));
      if (isLongEnough(row)) pieces.rows.push_back(row);
    }
  }
  return pieces;
}

}  // namespace

RowPlan scanLineRows(const scan::FittedScan& scan, const CuttingOptions& options, const toolpath::Region& region) {
  const Pieces pieces = piecesOfLines(scan, options, region);
  if (pieces.numbers.empty()) {
    throw InputError("cutting: none of " + std::to_string(scan.lines.size()) +
                     " fitted lines is longer than the edge margins");
  }
  return planOf(withoutSkipped(pieces.rows, options.skip_rows), pieces.numbers, pieces.rows, Eigen::Vector2d::UnitY(),
                toolpath::ScanSurface(scan.surface), options.ball_radius);
}

}  // namespace scan_to_path::process
