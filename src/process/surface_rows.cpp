// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/surface_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/process/row_plan.h"
#include "scan_to_path/process/row_scallop.h"
#include "scan_to_path/toolpath/outline_clip.h"
#include "scan_to_path/toolpath/scallop.h"

namespace scan_to_path::process {
namespace {

using Eigen::Vector2d;
using toolpath::HeightJet;
using toolpath::Interval;
using toolpath::OutlineClip;
using toolpath::ScanSurface;

constexpr double shortest_row = 1e-4;   // [m]; shorter stretches hold no contact worth a link
constexpr double edge_accuracy = 1e-7;  // [m] to which the first and last row are brought to the edge
constexpr double edge_wobble = 1e-4;    // [m]; the outline is measured: a row nearer to it may be in and out of it
constexpr double least_share = 0.93;    // of the scallop height that a step uses, but for the last one, …
constexpr double aimed_share = 0.97;    // … that it aims at …
constexpr double most_share = 0.995;    // … and that it may reach, for what lies between the places looked at
constexpr int most_rows = 10000;        // a part of 1 m at 0.1 mm; more take minutes and gigabytes
constexpr int most_trials = 20;         // per row; the secant needs one to three

/// Makes rows at any place across, and finds the next place.
class RowMaker {
public:
  RowMaker(const scan::FittedScan& scan, const CuttingOptions& options)
      : options_(options),
        surface_(scan.surface),
        clip_(scan.outline, options.direction, options.edge_margin),
        along_(std::cos(options.direction), std::sin(options.direction)),
        across_(-along_.y(), along_.x()) {}

  const ScanSurface& surface() const { return surface_; }

  /// The least (sign +1) or largest (sign -1) place across where there is a row.
  double edge(int sign) const {
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

  std::vector<Row> rowsAt(double s, int number) const {
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

  /// The pieces of a row in a region; the row itself where it is whole.
  std::vector<Row> inRegion(const Row& row, const toolpath::Region& region) const {
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

  /// Unit, in the scan plane.
  const Vector2d& across() const { return across_; }

  /// How far the next row's plane may be by the exact rule with this row's curvatures and slopes; NaN without a row.
  double ruleDistance(const std::vector<Row>& rows) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Row& row : rows) {
      for (const RowPoint& p : row.points) least = std::min(least, ruleDistanceAt(p));
    }
    return std::isfinite(least) ? least : planeDistance();
  }

  /// L of the rule on a plane.
  double planeDistance() const { return toolpath::rowDistance(options_.scallop_height, options_.ball_radius, 0.0); }

private:
  HeightJet jetAt(double t, double s) const {
    const Vector2d xy = t * along_ + s * across_;
    return surface_.jet(xy.x(), xy.y());
  }

  bool hasRow(double s) const {
    const auto intervals = clip_.inside(s);
    return std::any_of(intervals.begin(), intervals.end(),
                       [](const Interval& i) { return i.end - i.begin >= shortest_row; });
  }

  /// Length of the rows at s, seen from above [m].
  double coveredAt(double s) const {
    double length = 0.0;
    for (const Interval& interval : clip_.inside(s)) length += interval.end - interval.begin;
    return length;
  }

  RowPoint pointAt(double t, double s) const {
    const HeightJet jet = jetAt(t, s);
    const Vector2d xy = t * along_ + s * across_;
    RowPoint p;
    p.t = t;
    p.point = {xy.x(), xy.y(), jet.z};
    p.normal = toolpath::normalOf(jet);
    p.tangent = Vector3(along_.x(), along_.y(), along_.dot(Vector2d(jet.zx, jet.zy))).normalized();
    return p;
  }

  /// Waypoints per metre of t that keep the chord of the contact line and of the ball's centre within the tolerance.
  double density(double t, double s) const {
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

  /// Points at equal shares of the integrated density; per cell the density is its larger end's.
  std::vector<RowPoint> sampled(const Interval& interval, double s) const {
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

  double ruleDistanceAt(const RowPoint& p) const {
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

  const CuttingOptions& options_;
  ScanSurface surface_;
  OutlineClip clip_;
  Vector2d along_;
  Vector2d across_;
};

struct NextRow {
  double s = 0.0;
  std::vector<Row> rows;
  double scallop = 0.0;
};

/// The row at s and what it leaves next to the one before.
NextRow rowAt(const RowMaker& maker, const std::vector<Row>& before, double s, int number,
              const CuttingOptions& options) {
  NextRow next;
  next.s = s;
  next.rows = maker.rowsAt(s, number);
  next.scallop = widestScallop(before, next.rows, maker.surface(), options.ball_radius).value_or(0.0);
  return next;
}

/// The next row as far away as the scallop height allows, by trial: a scallop grows with the distance squared.
NextRow nextByScallop(const RowMaker& maker, const std::vector<Row>& before, double s, double last, int number,
                      const CuttingOptions& options) {
  const double h = options.scallop_height;
  double step = maker.ruleDistance(before);
  double allowed = 0.0;
  double too_far = std::numeric_limits<double>::infinity();
  NextRow next;
  for (int trial = 0; trial < most_trials; ++trial) {
    NextRow tried = rowAt(maker, before, std::min(s + step, last), number, options);
    const double scallop = tried.scallop;
    const bool is_enough = scallop >= least_share * h || scallop == 0.0 || tried.s >= last;
    if (scallop <= most_share * h) {
      allowed = step;
      next = std::move(tried);
      if (is_enough) return next;
    } else {
      too_far = step;
    }
    const double factor = std::sqrt(aimed_share * h / std::max(scallop, 0.1 * h));
    step *= std::clamp(factor, 0.3, 2.0);
    if (step <= allowed || step >= too_far) step = std::isfinite(too_far) ? 0.5 * (allowed + too_far) : 2.0 * allowed;
  }
  if (allowed > 0.0) return next;
  // Only next to a gouge does no distance help; the rule, which leaves such places out, goes on from there.
  return rowAt(maker, before, std::min(s + maker.ruleDistance(before), last), number, options);
}

void checkRowCount(double count, const CuttingOptions& options) {
  if (count <= most_rows) return;
  const bool by_pitch = options.pitch > 0.0;
  const std::string value = fixed(1e6 * (by_pitch ? options.pitch : options.scallop_height), 3);
  throw InputError(std::string("path.") + (by_pitch ? "pitch" : "scallop_height") + " of " + value + " um",
                   "number of rows", fixed(std::ceil(count), 0), "at most " + std::to_string(most_rows));
}

/// What of the whole part's rows is driven.
RowPlan chosenRows(const RowMaker& maker, const RowPlan& whole, const CuttingOptions& options,
                   const toolpath::Region& region) {
  std::vector<int> numbers;
  std::vector<Row> pieces;
  for (const Row& row : whole.rows) {
    if (numbers.empty() || numbers.back() != row.row) numbers.push_back(row.row);
    for (Row& piece : maker.inRegion(row, region)) pieces.push_back(std::move(piece));
  }
  return planOf(withoutSkipped(std::move(pieces), options.skip_rows), numbers, maker.across(), maker.surface(),
                options.ball_radius);
}

}  // namespace

RowPlan surfaceRows(const scan::FittedScan& scan, const CuttingOptions& options, const Progress& progress,
                    const toolpath::Region& region) {
  const bool takes_all = region.isEverything() && options.skip_rows.empty();
  const RowMaker maker(scan, options);
  const double first = maker.edge(1);
  const double last = maker.edge(-1);
  checkRowCount((last - first) / (options.pitch > 0.0 ? options.pitch : maker.planeDistance()), options);
  RowPlan plan;
  int number = 0;
  std::vector<Row> before = maker.rowsAt(first, number);
  plan.rows = before;
  for (double s = first; s < last;) {
    progress.update("path", (s - first) / (last - first));
    checkRowCount(++number, options);
    NextRow next = options.pitch > 0.0 ? rowAt(maker, before, std::min(s + options.pitch, last), number, options)
                                       : nextByScallop(maker, before, s, last, number, options);
    if (takes_all) checkThatBallsMeet(next.scallop, number, options.ball_radius);
    plan.distances.push_back(next.s - s);
    plan.widest_scallop = std::max(plan.widest_scallop, next.scallop);
    plan.rows.insert(plan.rows.end(), next.rows.begin(), next.rows.end());
    s = next.s;
    before = std::move(next.rows);
  }
  plan.last_row = number;
  return takes_all ? plan : chosenRows(maker, plan, options, region);
}

}  // namespace scan_to_path::process
