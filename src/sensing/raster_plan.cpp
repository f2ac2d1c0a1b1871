// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/raster_plan.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {
namespace {

constexpr double most_rows = 100000.0;

/// Offsets of the rows across, from the first one [m].
std::vector<double> rowOffsets(double width, const RasterOptions& options) {
  const double other = options.pitch_alternate > 0.0 ? options.pitch_alternate : options.pitch;
  if (width / std::min(options.pitch, other) > most_rows) {
    throw InputError("raster", "pitch", fixed(options.pitch, 6) + " m",
                     "at least a " + fixed(most_rows, 0) + "th of the width, " + fixed(width, 6) + " m");
  }
  std::vector<double> offsets = {0.0};
  const double rounding = 1e-9 * width;
  for (bool is_first = true;; is_first = !is_first) {
    const double next = offsets.back() + (is_first ? options.pitch : other);
    if (next >= width - rounding) return offsets;
    offsets.push_back(next);
  }
}

/// The rectangle that encloses `rectangle` in axes turned by `angle` about its centre, relative to the centre.
Eigen::AlignedBox2d turnedExtent(const Eigen::AlignedBox2d& rectangle, const Eigen::Rotation2Dd& turn) {
  Eigen::AlignedBox2d extent;
  for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                            Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
    extent.extend(turn.inverse() * (rectangle.corner(corner) - rectangle.center()));
  }
  return extent;
}

void checkRectangle(const Eigen::AlignedBox2d& rectangle) {
  const Eigen::Vector2d size = rectangle.sizes();
  for (int axis = 0; axis < 2; ++axis) {
    if (!(std::isfinite(rectangle.min()[axis]) && std::isfinite(rectangle.max()[axis]) && size[axis] > 0.0)) {
      throw InputError("raster", axis == 0 ? "extent along x" : "extent along y", fixed(size[axis], 6) + " m",
                       "positive and finite");
    }
  }
}

void appendMove(const Vector3& from, const Vector3& to, int row, bool is_row, const RasterOptions& options,
                RasterPlan& plan) {
  RasterMove move;
  move.from = from;
  move.to = to;
  move.row = row;
  move.is_row = is_row;
  move.is_recorded = is_row || options.order == RasterOrder::zig_zag;
  move.profile = TrapezoidProfile((to - from).norm(), options.speed, options.acceleration);
  move.begin = plan.duration;
  plan.duration += move.profile.duration();
  plan.moves.push_back(move);
}

}  // namespace

TrapezoidProfile::TrapezoidProfile(double length, double speed, double acceleration)
    : length_(length), acceleration_(acceleration) {
  const double top_speed = std::min(speed, std::sqrt(length * acceleration));
  ramp_ = top_speed / acceleration;
  cruise_ = top_speed > 0.0 ? std::max(0.0, length / top_speed - ramp_) : 0.0;
}

double TrapezoidProfile::distanceAt(double time) const {
  if (time < ramp_) return 0.5 * acceleration_ * time * time;
  if (time <= ramp_ + cruise_) return acceleration_ * ramp_ * (time - 0.5 * ramp_);
  const double rest = std::max(0.0, duration() - time);
  return length_ - 0.5 * acceleration_ * rest * rest;
}

RasterPlan planRaster(const Eigen::AlignedBox2d& rectangle, const RasterOptions& options) {
  validate(options, "raster");
  checkRectangle(rectangle);
  const Eigen::Rotation2Dd turn(options.row_angle);
  const Eigen::AlignedBox2d extent = turnedExtent(rectangle, turn);
  const std::vector<double> offsets = rowOffsets(extent.sizes().y(), options);
  const auto at = [&](double along, double across) {
    const Eigen::Vector2d xy = rectangle.center() + turn * Eigen::Vector2d(along, across);
    return Vector3(xy.x(), xy.y(), options.height);
  };

  RasterPlan plan;
  plan.rows = static_cast<int>(offsets.size());
  const double half_length = extent.max().x() + options.overscan;
  for (int row = 0; row < plan.rows; ++row) {
    const double across = offsets[static_cast<std::size_t>(row)] - 0.5 * offsets.back();
    const bool is_forward = options.order == RasterOrder::one_way || row % 2 == 0;
    const double begin = is_forward ? -half_length : half_length;
    if (row > 0) appendMove(plan.moves.back().to, at(begin, across), row, false, options, plan);
    appendMove(at(begin, across), at(-begin, across), row, true, options, plan);
  }
  // The beam is the workpiece's -z; beam_turn turns about it.
  const Eigen::Vector2d row_direction = turn * Eigen::Vector2d::UnitX();
  const Frame T =
      geometry::frameFromAxes(Vector3::Zero(), -Vector3::UnitZ(), {row_direction.x(), row_direction.y(), 0});
  plan.R_workpiece_sensor = T.linear() * Eigen::AngleAxisd(options.beam_turn, Vector3::UnitZ());
  return plan;
}

std::size_t moveAt(const RasterPlan& plan, double time, std::size_t cursor) {
  const auto& moves = plan.moves;
  if (cursor >= moves.size() || moves[cursor].begin > time) cursor = 0;
  if (cursor + 1 >= moves.size() || moves[cursor + 1].begin > time) return cursor;
  const auto after = std::upper_bound(moves.begin() + static_cast<std::ptrdiff_t>(cursor), moves.end(), time,
                                      [](double t, const RasterMove& move) { return t < move.begin; });
  return static_cast<std::size_t>(after - moves.begin()) - 1;
}

}  // namespace scan_to_path::sensing
