// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "row_maker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scan_to_path/common/error.h"
#include "scan_to_path/toolpath/scallop.h"

namespace scan_to_path::process {
namespace {

using Eigen::Vector2d;
using toolpath::HeightJet;
using toolpath::Interval;

constexpr double shortest_row = 1e-4;   // [m]; shorter stretches hold no contact worth a link
constexpr double edge_accuracy = 1e-7;  // [m] to which the first and last row are brought to the edge
constexpr double edge_wobble = 1e-4;    // [m]; the outline is measured: a row nearer to it may be in and out of it

}  // namespace

RowMaker::RowMaker(const scan::FittedScan& scan, const CuttingOptions& options)
    : options_(options),
      surface_(scan.surface),
      clip_(scan.outline, options.direction, options.edge_margin),
      along_(std::cos(options.direction), std::sin(options.direction)),
      across_(-along_.y(), along_.x()) {}

double RowMaker::edge(int sign) const {
  const double start = (sign > 0 ? clip_.first() : clip_.last()) + sign * options_.edge_margin;
  const double extent = clip_.last() - clip_.first();
  const double stride = std::min(0.25 * planeDistance(), extent / 64.0);
  double bare = start;
  double found = start + sign * edge_accuracy;
  while (!hasRow(found)) {
    bare = found;
    found += sign * stride;
    if (std::abs(found - start) > extent) {
      throw InputError("cutting: no row fits into the part's outline with an edge margin of " +
                       std::to_string(1e3 * options_.edge_margin) + " mm");
    }
  }
  while (std::abs(found - bare) > edge_accuracy) {
    const double middle = 0.5 * (bare + found);
    (hasRow(middle) ? found : bare) = middle;
  }
  const double settled = found + sign * edge_wobble;
  return coveredAt(settled) > 1.01 * coveredAt(found) ? settled : found;
}

std::vector<Row> RowMaker::rowsAt(double s, int number) const {
  std::vector<Row> rows;
  for (const Interval& interval : clip_.inside(s)) {
    if (interval.end - interval.begin < shortest_row) continue;
    Row row;
    row.row = number;
    row.piece = static_cast<int>(rows.size());
    row.points = sampled(interval, s);
    rows.push_back(std::move(row));
  }
  for (Row& row : rows) row.pieces = static_cast<int>(rows.size());
  return rows;
}

std::vector<Row> RowMaker::inRegion(const Row& row, const toolpath::Region& region) const {
  const double s = across_.dot(row.points.front().point.head<2>());
  std::vector<double> places;
  for (const RowPoint& p : row.points) places.push_back(p.t);
  std::vector<Row> pieces;
  for (const Interval& interval : region.inside([&](double t) { return pointAt(t, s).point; }, places)) {
    if (interval.end - interval.begin < shortest_row) continue;
    pieces.push_back(row);
    const bool is_whole = interval.begin == places.front() && interval.end == places.back();
    if (!is_whole) pieces.back().points = sampled(interval, s);
  }
  return pieces;
}

double RowMaker::ruleDistance(const std::vector<Row>& rows) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Row& row : rows) {
    for (const RowPoint& p : row.points) least = std::min(least, ruleDistanceAt(p));
  }
  return std::isfinite(least) ? least : planeDistance();
}

HeightJet RowMaker::jetAt(double t, double s) const {
  const Vector2d xy = t * along_ + s * across_;
  return surface_.jet(xy.x(), xy.y());
}

bool RowMaker::hasRow(double s) const {
  const auto intervals = clip_.inside(s);
  return std::any_of(intervals.begin(), intervals.end(),
                     [](const Interval& i) { return i.end - i.begin >= shortest_row; });
}

double RowMaker::coveredAt(double s) const {
  double length = 0.0;
  for (const Interval& interval : clip_.inside(s)) length += interval.end - interval.begin;
  return length;
}

RowPoint RowMaker::pointAt(double t, double s) const {
  const HeightJet jet = jetAt(t, s);
  const Vector2d xy = t * along_ + s * across_;
  RowPoint p;
  p.t = t;
  p.point = {xy.x(), xy.y(), jet.z};
  p.normal = toolpath::normalOf(jet);
  p.tangent = Vector3(along_.x(), along_.y(), along_.dot(Vector2d(jet.zx, jet.zy))).normalized();
  return p;
}

double RowMaker::density(double t, double s) const {
  const HeightJet jet = jetAt(t, s);
  const double slope = along_.dot(Vector2d(jet.zx, jet.zy));
  const double stretch = std::sqrt(1.0 + slope * slope);
  const double second =
      jet.zxx * along_.x() * along_.x() + 2.0 * jet.zxy * along_.x() * along_.y() + jet.zyy * along_.y() * along_.y();
  const double section = std::abs(second) / (stretch * stretch * stretch);
  const double normal = toolpath::normalCurvature(jet, along_);
  // A chord of length l sags kappa l^2 / 8; the centre's line is 1 + kappa r longer and turns as much.
  const double bend = std::max(section, section * (1.0 + normal * options_.ball_radius));
  return stretch * std::max(std::sqrt(bend / (8.0 * options_.chord_tolerance)), 1.0 / options_.max_spacing);
}

std::vector<RowPoint> RowMaker::sampled(const Interval& interval, double s) const {
  const double length = interval.end - interval.begin;
  const auto cells = static_cast<std::size_t>(std::max(8.0, std::ceil(4.0 * length / options_.max_spacing)));
  const double cell = length / static_cast<double>(cells);
  std::vector<double> needed(cells + 1, 0.0);
  double before = density(interval.begin, s);
  for (std::size_t i = 0; i < cells; ++i) {
    const double after = density(interval.begin + static_cast<double>(i + 1) * cell, s);
    needed[i + 1] = needed[i] + cell * std::max(before, after);
    before = after;
  }
  const auto moves = static_cast<std::size_t>(std::max(1.0, std::ceil(needed.back())));
  std::vector<RowPoint> points;
  points.reserve(moves + 1);
  std::size_t i = 0;
  for (std::size_t k = 0; k < moves; ++k) {
    const double share = needed.back() * static_cast<double>(k) / static_cast<double>(moves);
    while (needed[i + 1] <= share) ++i;
    const double in_cell = (share - needed[i]) / (needed[i + 1] - needed[i]);
    points.push_back(pointAt(interval.begin + (static_cast<double>(i) + in_cell) * cell, s));
  }
  points.push_back(pointAt(interval.end, s));
  return points;
}

double RowMaker::ruleDistanceAt(const RowPoint& p) const {
  const HeightJet jet = surface_.jet(p.point.x(), p.point.y());
  const Vector3 e(across_.x(), across_.y(), 0.0);
  const Vector3 g = e - p.normal * p.normal.dot(e);
  const double curvature = toolpath::normalCurvature(jet, Vector2d(g.x(), g.y()));
  const double r = options_.ball_radius;
  // A hollow that the ball does not fit into is a gouge, which says so itself; an edge leaves no scallop.
  if (curvature * r <= -1.0 || options_.scallop_height >= toolpath::largestScallop(r, curvature)) {
    return std::numeric_limits<double>::infinity();
  }
  return toolpath::rowDistance(options_.scallop_height, r, curvature) * g.norm();  // L cos(slope), step 11
}

double RowMaker::planeDistance() const {
  return toolpath::rowDistance(options_.scallop_height, options_.ball_radius, 0.0);
}

}  // namespace scan_to_path::process
