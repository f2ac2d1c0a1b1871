// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/reference_stage.h"

#include <algorithm>

#include "scan_to_path/pipeline/path_stage.h"
#include "scan_to_path/scan/outline.h"
#include "scan_to_path/toolpath/scallop.h"
#include "scan_to_path/verification/path_deviation.h"
#include "scan_to_path/verification/scallop_check.h"

namespace scan_to_path::pipeline {
namespace {

using geometry::Frame;
using geometry::Vector3;

constexpr double along = 2e-3;   // [m] between looks along the rows
constexpr double across = 1e-4;  // [m] across them: a cusp falls by a tenth of what a look misses it by
constexpr double above = 1.0;    // [m] over the scan's origin, where the looks start

/// A grid over the outline, its x axis along the rows.
verification::SampleGrid gridOver(const scan::FittedScan& scan, double direction) {
  const Eigen::Rotation2Dd to_rows(-direction);
  Eigen::AlignedBox2d extent;
  for (const auto& polygon : scan.outline.polygons) {
    for (const auto& corner : polygon) extent.extend(to_rows * corner);
  }
  verification::SampleGrid grid;
  grid.T_surface_grid = scan.T_cloud_scan * geometry::makeFrame(Vector3(0.0, 0.0, above), Vector3(0.0, 0.0, direction));
  grid.x_min = extent.min().x();
  grid.x_max = extent.max().x();
  grid.y_min = extent.min().y();
  grid.y_max = extent.max().y();
  grid.spacing_x = along;
  grid.spacing_y = across;
  return grid;
}

/// Whether a place lies on the part and no nearer to its edge than the rows do, which leave the margin as it is.
bool isMachined(const scan::OutlineTest& part, const Vector3& p, double margin) {
  return part.inside(p.x() - margin, p.y()) && part.inside(p.x() + margin, p.y()) &&
         part.inside(p.x(), p.y() - margin) && part.inside(p.x(), p.y() + margin);
}

/// The reference's points over the machined part.
std::vector<geometry::SurfacePoint> machinedPoints(const scan::FittedScan& scan, double direction, double edge_margin,
                                                   const toolpath::Region& region, const geometry::Surface& reference) {
  auto points = verification::sampleSurface(reference, gridOver(scan, direction));
  const scan::OutlineTest part(scan.outline);
  const Frame T_scan_cloud = scan.T_cloud_scan.inverse();
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const auto& point) {
                                return !region.contains(point.point) ||
                                       !isMachined(part, T_scan_cloud * point.point, edge_margin);
                              }),
               points.end());
  return points;
}

/// The highest that counts as a cusp between rows [m]; more is uncut. Cusps grow with the square of the rows' distance:
/// where they are ten times as high as they are meant to be, rows are three times as far apart, so that some are
/// missing, and above the ball's radius balls on a plane do not meet. An edge makes them four times as high.
double highestCusp(const process::CuttingOptions& cutting, double scan_pitch) {
  constexpr double too_many_times = 10.0;
  const double r = cutting.ball_radius;
  const double given = cutting.row_source == process::RowSource::surface ? cutting.pitch : scan_pitch;
  const double meant = std::max(cutting.scallop_height, toolpath::scallopHeight(std::min(given, 2.0 * r), r, 0.0));
  return std::min(too_many_times * meant, r);
}

/// Without the passes that leave stock on the surface.
toolpath::ToolPath lastPass(const process::PlannedPath& planned) {
  toolpath::ToolPath last = planned.path;
  last.segments.clear();
  for (std::size_t s = 0; s < planned.path.segments.size(); ++s) {
    if (planned.allowances[s] == 0.0) last.segments.push_back(planned.path.segments[s]);
  }
  return last;
}

/// None of a partial path that has lost its last pass.
std::vector<Accuracy> pathFigures(const toolpath::ToolPath& last_pass, const geometry::Surface& reference,
                                  const ReportOptions& limits) {
  if (toolpath::travelOf(last_pass).worked <= 0.0) return {};
  const auto deviation = verification::measureDeviation(last_pass, reference);
  return {{"reference_path_rms", deviation.rms, "m"},
          {"reference_path_mean", deviation.mean, "m"},
          {"reference_path_largest", deviation.largest, "m", limitUnlessZero(limits.max_reference_path)},
          {"reference_normal_mean", deviation.normal_mean, "rad"},
          {"reference_normal_largest", deviation.normal_largest, "rad"},
          {"reference_contacts", static_cast<double>(deviation.contacts), "1"}};
}

}  // namespace

std::vector<Accuracy> compareWithReference(const process::PlannedPath& planned, const scan::FittedScan& scan,
                                           const JobOptions& options, const geometry::Surface& reference, int threads) {
  const process::CuttingOptions& cutting = options.path;
  const ReportOptions& limits = options.report;
  std::vector<Accuracy> figures = pathFigures(lastPass(planned), reference, limits);
  const double direction = cutting.row_source == process::RowSource::surface ? cutting.direction : 0.0;
  const auto points = machinedPoints(scan, direction, cutting.edge_margin, regionOf(options), reference);
  if (points.empty()) return figures;
  const auto scallop =
      verification::checkScallops(planned.path, cutting.ball_radius, points, highestCusp(cutting, scan.pitch), threads);
  figures.push_back({"reference_scallop_largest", scallop.highest, "m", limitUnlessZero(limits.max_reference_scallop)});
  figures.push_back({"reference_scallop_mean", scallop.mean, "m"});
  figures.push_back({"reference_deepest_cut", scallop.deepest_cut, "m", limitUnlessZero(limits.max_reference_cut)});
  figures.push_back(
      {"reference_uncut_share", static_cast<double>(scallop.uncut) / static_cast<double>(scallop.points), "1"});
  return figures;
}

}  // namespace scan_to_path::pipeline
