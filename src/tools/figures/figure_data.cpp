// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "figure_data.h"

#include <algorithm>
#include <cmath>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <limits>

#include "pca_normals.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/robot/kdl_chain.h"
#include "scan_to_path/sensing/emulate_scan.h"
#include "scan_to_path/toolpath/scan_surface.h"
#include "tools/emulated_world.h"

namespace scan_to_path::tools {
namespace {

// The cloud that normals are taken from: as dense along the lines as scanners make it, which is what the k nearest
// neighbours cannot cope with.
constexpr double point_spacing = 1e-4;   // [m]
constexpr double arrow_spacing = 10e-3;  // [m] along lines
constexpr int rows_per_arrow_row = 2;
constexpr int pca_neighbours = 20;

constexpr double detail_length = 3e-3;  // [m]
constexpr int detail_curve_points = 100;

constexpr double outline_step = 2e-3;  // [m] so that lines of the outline follow the surface

pipeline::ScanStage emulate(const pipeline::JobOptions& options, const pipeline::Cell& cell, int threads) {
  const World world = makeWorld({});
  const auto emulated = sensing::emulateScan(*world.scene, world.rectangle(), cell.T_base_workpiece, cell.robot,
                                             cell.encoders, cell.laser, cell.T_tip_sensor, options.emulate, threads);
  return pipeline::scanFromSamples(emulated.log, cell, options.scan, options.report, threads, {});
}

scan::ScanCloud pointsOf(const scan::SampleRows& rows, const scan::ScanCloud& cloud) {
  scan::ScanCloud left;
  for (const auto& piece : rows.pieces) {
    for (const auto index : piece.index) left.push_back(cloud[index]);
  }
  return left;
}

/// The polygon with further corners on its sides, none longer than a step; closed.
std::vector<Eigen::Vector2d> densified(const std::vector<Eigen::Vector2d>& polygon, double step) {
  std::vector<Eigen::Vector2d> dense;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
    const int parts = std::max(1, static_cast<int>(std::ceil(side.norm() / step)));
    for (int k = 0; k < parts; ++k) dense.push_back(polygon[i] + side * k / parts);
  }
  return dense;
}

std::vector<std::vector<Vector3>> liftedOutline(const scan::FittedScan& scan) {
  const toolpath::ScanSurface surface(scan.surface);
  std::vector<std::vector<Vector3>> outline;
  for (const auto& polygon : scan.outline.polygons) {
    outline.emplace_back();
    for (const auto& p : densified(polygon, outline_step)) {
      outline.back().push_back(scan.T_cloud_scan * Vector3(p.x(), p.y(), surface.height(p.x(), p.y())));
    }
  }
  return outline;
}

const scan::FittedLine& middleLine(const scan::FittedScan& scan) { return scan.lines[scan.lines.size() / 2]; }

/// Middle of the stretch of the line, detail_length long, that bends least: sum of second derivatives.
double straightestPlace(const scan::FittedLine& line) {
  const auto places = scan::resampleParameters(line, {detail_length, 0.0});
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i + 2 < places.size(); ++i) {
    const Vector3 a = nurbs::pointAt(line.curve, places[i - 1]);
    const Vector3 b = nurbs::pointAt(line.curve, places[i]);
    const Vector3 c = nurbs::pointAt(line.curve, places[i + 1]);
    const double bend = (a - 2.0 * b + c).norm();
    if (bend >= least) continue;
    least = bend;
    best = places[i];
  }
  return best;
}

FitDetail detailOf(const scan::FittedScan& scan, const scan::ScanCloud& cloud) {
  const scan::FittedLine& line = middleLine(scan);
  const auto centre = nurbs::evaluate(line.curve, straightestPlace(line));
  const Vector3 x = centre.first.normalized();
  const Vector3 y = (scan.T_cloud_scan.linear() * Vector3::UnitZ()).cross(x).normalized();
  Frame T_cloud_detail = Frame::Identity();
  T_cloud_detail.linear() << x, y, x.cross(y);
  T_cloud_detail.translation() = centre.point;
  const Frame T_detail_cloud = T_cloud_detail.inverse();
  const auto is_inside = [&](const Vector3& p) {
    return std::abs(p.x()) < 0.5 * detail_length && std::abs(p.y()) < 0.25 * scan.pitch;
  };
  FitDetail detail;
  for (const auto& point : cloud) {
    const Vector3 p = T_detail_cloud * point.getVector3fMap().cast<double>();
    if (is_inside(p)) detail.samples.push_back(p);
  }
  for (const double parameter : scan::resampleParameters(line, {detail_length / detail_curve_points, 0.0})) {
    const Vector3 p = T_detail_cloud * nurbs::pointAt(line.curve, parameter);
    if (is_inside(p)) detail.curve.push_back(p);
  }
  return detail;
}

NormalComparison compareNormals(const scan::FittedScan& scan, const scan::FitOptions& options) {
  const scan::NormalEstimator estimator(scan, options.normals);
  NormalComparison comparison;
  const auto every = static_cast<std::size_t>(arrow_spacing / point_spacing);
  for (std::size_t i = 0; i < scan.lines.size(); ++i) {
    const auto oriented =
        estimator.orient(static_cast<int>(i), scan::resampleParameters(scan.lines[i], {point_spacing, 0.0}));
    for (std::size_t k = 0; k < oriented.points.size(); ++k) {
      if (scan.lines[i].row % rows_per_arrow_row == 0 && k % every == every / 2) {
        comparison.chosen.push_back(comparison.points.size());
      }
      comparison.points.push_back(oriented.points[k].point);
      comparison.normals.push_back(oriented.points[k].normal);
    }
  }
  const Vector3 sensor = scan.T_cloud_scan * Vector3::UnitZ();
  comparison.pca_normals = pcaNormals(comparison.points, comparison.chosen, pca_neighbours, sensor);
  return comparison;
}

/// The middle one of the segments that work on the part.
int middleRow(const toolpath::ToolPath& path) {
  std::vector<int> rows;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    if (path.segments[s].name.rfind("row_", 0) == 0) rows.push_back(static_cast<int>(s));
  }
  if (rows.empty()) throw InputError("figures: the path has no row");
  return rows[rows.size() / 2];
}

RowPlayback playBackRow(const toolpath::ToolPath& path, const motion::Trajectory& trajectory,
                        const pipeline::Cell& cell) {
  const int row = middleRow(path);
  RowPlayback playback;
  for (const auto& waypoint : path.segments[static_cast<std::size_t>(row)].waypoints) {
    playback.planned.push_back(waypoint.pose * path.T_contact_tcp);
  }
  const KDL::Chain chain = robot::kdlChain(cell.robot);
  KDL::ChainFkSolverPos_recursive forward(chain);
  std::vector<robot::JointVector> driven;
  for (const auto& point : trajectory.points) {
    if (point.segment == row) driven.push_back(point.q);
  }
  if (driven.empty()) throw InputError("figures: the motion does not drive row segment " + std::to_string(row));
  for (const auto& q : driven) {
    KDL::JntArray angles(static_cast<unsigned>(q.size()));
    angles.data = q;
    KDL::Frame T_base_tip;
    forward.JntToCart(angles, T_base_tip);
    playback.played_back.push_back((robot::fromKdl(T_base_tip) * cell.T_tip_tcp).translation());
  }
  playback.joints = driven[driven.size() / 2];
  return playback;
}

}  // namespace

FigureData makeFigureData(pipeline::JobOptions options, const std::vector<std::filesystem::path>& package_path,
                          int seed, int threads) {
  options.emulate.errors = sensing::errorPreset(sensing::ErrorSet::realistic);
  options.emulate.seed = seed;
  FigureData data(options, pipeline::makeCell(options.cell, package_path));
  const auto scanned = emulate(options, data.cell, threads);
  const auto rows = scan::cleanRows(*scanned.cloud, scanned.mean_beam, options.scan.cloud, threads);
  pipeline::FitStage fitted;
  fitted.scan = scan::fitRows(rows, options.fit, threads);
  data.filtered = pointsOf(rows, *scanned.cloud);
  data.outline = liftedOutline(fitted.scan);
  data.detail = detailOf(fitted.scan, data.filtered);
  data.normals = compareNormals(fitted.scan, options.fit);
  const auto planner = pipeline::makePlanner("cutting", options);
  data.path = pipeline::pathStage(*planner, fitted.scan, options.cell.base_link, options, {});
  data.motion = pipeline::motionStage(data.path, data.cell, options, {});
  data.row = playBackRow(data.path.planned.path, data.motion.plan.trajectory, data.cell);
  data.raw = *scanned.cloud;
  return data;
}

}  // namespace scan_to_path::tools
