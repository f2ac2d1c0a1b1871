// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/background.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/random.h"

namespace scan_to_path::scan {
namespace {

/// At most about `wanted` samples of the pieces that are the far side of a depth jump.
std::vector<Vector3> farSideSamples(const SampleRows& rows, std::size_t wanted) {
  const auto is_far_side = [](const RowPiece& piece) {
    const bool lower_at_begin = piece.begins == PieceEnd::step_up;
    const bool lower_at_end = piece.ends == PieceEnd::step_up;
    return (lower_at_begin || lower_at_end) && piece.begins != PieceEnd::step_down && piece.ends != PieceEnd::step_down;
  };
  std::size_t total = 0;
  for (const RowPiece& piece : rows.pieces) total += is_far_side(piece) ? piece.size() : 0;
  const std::size_t stride = total / wanted + 1;
  std::vector<Vector3> samples;
  for (const RowPiece& piece : rows.pieces) {
    if (!is_far_side(piece)) continue;
    for (std::size_t i = 0; i < piece.size(); i += stride) samples.emplace_back(piece.x[i], piece.y[i], piece.z[i]);
  }
  return samples;
}

std::optional<BackgroundPlane> planeThrough(const Vector3& p, const Vector3& q, const Vector3& r) {
  const Vector3 normal = (q - p).cross(r - p);
  if (!(std::abs(normal.z()) > 0.1 * normal.norm())) return std::nullopt;
  BackgroundPlane plane;
  plane.b = -normal.x() / normal.z();
  plane.c = -normal.y() / normal.z();
  plane.a = p.z() - plane.b * p.x() - plane.c * p.y();
  return plane;
}

std::size_t supportOf(const BackgroundPlane& plane, const std::vector<Vector3>& samples, double tolerance) {
  return static_cast<std::size_t>(std::count_if(samples.begin(), samples.end(), [&](const Vector3& p) {
    return std::abs(plane.heightAbove(p.x(), p.y(), p.z())) <= tolerance;
  }));
}

/// Least squares over the samples within the tolerance of `plane`.
BackgroundPlane refined(const BackgroundPlane& plane, const std::vector<Vector3>& samples, double tolerance) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Vector3 b = Vector3::Zero();
  for (const Vector3& p : samples) {
    if (std::abs(plane.heightAbove(p.x(), p.y(), p.z())) > tolerance) continue;
    const Vector3 row(1.0, p.x(), p.y());
    A += row * row.transpose();
    b += row * p.z();
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(A);
  if (!solver.isInvertible()) return plane;
  const Vector3 solution = solver.solve(b);
  return {solution.x(), solution.y(), solution.z()};
}

/// The plane with the largest support among those through seeded random triples.
std::optional<BackgroundPlane> bestPlane(const std::vector<Vector3>& samples, double tolerance) {
  constexpr int trials = 200;  // with half of the samples on it, one triple in eight spans the plane
  Random random(1);
  std::optional<BackgroundPlane> best;
  std::size_t most = 0;
  const auto pick = [&] {
    return samples[static_cast<std::size_t>(random.uniform() * static_cast<double>(samples.size()))];
  };
  for (int trial = 0; trial < trials; ++trial) {
    const Vector3 p = pick();
    const Vector3 q = pick();
    const Vector3 r = pick();
    const auto plane = planeThrough(p, q, r);
    if (!plane) continue;
    const std::size_t support = supportOf(*plane, samples, tolerance);
    if (support <= most) continue;
    most = support;
    best = plane;
  }
  if (best) best = refined(refined(*best, samples, tolerance), samples, tolerance);
  return best;
}

bool onBackground(const BackgroundPlane& plane, const RowPiece& piece, std::size_t i, double tolerance) {
  return plane.heightAbove(piece.x[i], piece.y[i], piece.z[i]) <= tolerance;
}

bool nothingBeyond(const SampleRows& rows, const BackgroundPlane& plane, double tolerance) {
  std::size_t beyond = 0;
  for (const RowPiece& piece : rows.pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (plane.heightAbove(piece.x[i], piece.y[i], piece.z[i]) < -tolerance) ++beyond;
    }
  }
  return beyond * 1000 <= sampleCount(rows);
}

/// Share of a row's samples on the plane.
double shareOnPlane(const SampleRows& rows, const BackgroundPlane& plane, int row, double tolerance) {
  std::size_t on_plane = 0;
  std::size_t all = 0;
  for (const RowPiece& piece : rows.pieces) {
    if (piece.row != row) continue;
    all += piece.size();
    for (std::size_t i = 0; i < piece.size(); ++i) on_plane += onBackground(plane, piece, i, tolerance) ? 1 : 0;
  }
  return all > 0 ? static_cast<double>(on_plane) / static_cast<double>(all) : 0.0;
}

/// True when the scan ends on the plane on two opposite sides.
bool surroundsPart(const SampleRows& rows, const BackgroundPlane& plane, const BackgroundOptions& options) {
  int row_count = 0;
  int begins_on = 0;
  int ends_on = 0;
  for (std::size_t k = 0; k < rows.pieces.size(); ++k) {
    const RowPiece& piece = rows.pieces[k];
    const bool first = k == 0 || rows.pieces[k - 1].row != piece.row;
    const bool last = k + 1 == rows.pieces.size() || rows.pieces[k + 1].row != piece.row;
    row_count += first ? 1 : 0;
    begins_on += first && onBackground(plane, piece, 0, options.tolerance) ? 1 : 0;
    ends_on += last && onBackground(plane, piece, piece.size() - 1, options.tolerance) ? 1 : 0;
  }
  const double least = options.border_share * row_count;
  if (begins_on >= least && ends_on >= least) return true;
  const auto row_on = [&](const RowPiece& piece) {
    return shareOnPlane(rows, plane, piece.row, options.tolerance) >= options.border_share;
  };
  return row_on(rows.pieces.front()) && row_on(rows.pieces.back());
}

bool wellSupported(const SampleRows& rows, const BackgroundPlane& plane, const BackgroundOptions& options) {
  std::size_t support = 0;
  std::set<int> on_rows;
  for (const RowPiece& piece : rows.pieces) {
    const std::size_t before = support;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      support += std::abs(plane.heightAbove(piece.x[i], piece.y[i], piece.z[i])) <= options.tolerance ? 1 : 0;
    }
    if (support > before) on_rows.insert(piece.row);
  }
  return support >= static_cast<std::size_t>(options.min_samples) && on_rows.size() >= 2;
}

bool isBackground(const SampleRows& rows, const BackgroundPlane& plane, const BackgroundOptions& options) {
  return wellSupported(rows, plane, options) && nothingBeyond(rows, plane, options.tolerance) &&
         surroundsPart(rows, plane, options);
}

/// Samples all along the scan's border: of the first and the last row, and of both ends of the rows.
std::vector<Vector3> borderSamples(const SampleRows& rows) {
  constexpr std::size_t at_end = 20;
  std::vector<Vector3> samples;
  for (std::size_t k = 0; k < rows.pieces.size(); ++k) {
    const RowPiece& piece = rows.pieces[k];
    const bool is_outer = piece.row == rows.pieces.front().row || piece.row == rows.pieces.back().row;
    const bool begins = k == 0 || rows.pieces[k - 1].row != piece.row;
    const bool ends = k + 1 == rows.pieces.size() || rows.pieces[k + 1].row != piece.row;
    const std::size_t stride = is_outer ? piece.size() / 200 + 1 : 4;
    for (std::size_t i = 0; i < piece.size(); i += stride) {
      const bool is_at_end = (begins && i < at_end) || (ends && i + at_end >= piece.size());
      if (is_outer || is_at_end) samples.emplace_back(piece.x[i], piece.y[i], piece.z[i]);
    }
  }
  return samples;
}

FlushPlane samplesOn(const SampleRows& rows, const BackgroundPlane& plane, double tolerance) {
  std::size_t count = 0;
  double sum = 0.0;
  for (const RowPiece& piece : rows.pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (!onBackground(plane, piece, i, tolerance)) continue;
      ++count;
      sum += piece.z[i];
    }
  }
  const double height = sum / static_cast<double>(std::max<std::size_t>(count, 1));
  return {static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(sampleCount(rows), 1)),
          height + rows.T_cloud_scan.translation().dot(rows.T_cloud_scan.linear().col(2))};
}

/// The user's height in the cloud's frame, as a plane across the beam of the scan frame.
BackgroundPlane planeAtHeight(const SampleRows& rows, double height) {
  const Vector3 origin = rows.T_cloud_scan.translation();
  return {height - origin.dot(rows.T_cloud_scan.linear().col(2)), 0.0, 0.0};
}

/// The stretches of a piece above the plane; the rest counts as dropped.
void keepAbove(const RowPiece& piece, const BackgroundPlane& plane, const BackgroundOptions& options,
               SampleRows& kept) {
  const std::size_t n = piece.size();
  std::size_t background = 0;
  std::size_t begin = 0;
  while (begin < n) {
    const bool is_background = onBackground(plane, piece, begin, options.tolerance);
    std::size_t end = begin + 1;
    while (end < n && onBackground(plane, piece, end, options.tolerance) == is_background) ++end;
    const bool is_short = piece.x[end - 1] - piece.x[begin] < options.min_length;
    if (is_background || is_short) addObstacles(piece, begin, end, kept.obstacles);
    if (is_background) {
      background += end - begin;
    } else if (is_short) {
      addDropped(kept.dropped, "short piece", end - begin);
    } else {
      kept.pieces.push_back(subPiece(piece, begin, end));
      if (begin > 0) kept.pieces.back().begins = PieceEnd::step_down;
      if (end < n) kept.pieces.back().ends = PieceEnd::step_down;
    }
    begin = end;
  }
  addDropped(kept.dropped, "background", background);
}

}  // namespace

std::optional<BackgroundPlane> findBackground(const SampleRows& rows, const BackgroundOptions& options) {
  validate(options, "background");
  if (options.mode == BackgroundMode::none || rows.pieces.empty()) return std::nullopt;
  if (options.mode == BackgroundMode::height) return planeAtHeight(rows, options.height);
  const std::vector<Vector3> samples = farSideSamples(rows, 4000);
  if (samples.size() < 3) return std::nullopt;
  const auto plane = bestPlane(samples, options.tolerance);
  if (!plane || !isBackground(rows, *plane, options)) return std::nullopt;
  return plane;
}

std::optional<FlushPlane> findFlushPlane(const SampleRows& rows, BackgroundOptions options) {
  validate(options, "background");
  if (options.mode != BackgroundMode::automatic) return std::nullopt;
  options.tolerance *= 0.1;
  const std::vector<Vector3> samples = borderSamples(rows);
  if (samples.size() < 3) return std::nullopt;
  const auto plane = bestPlane(samples, options.tolerance);
  if (!plane || !isBackground(rows, *plane, options)) return std::nullopt;
  return samplesOn(rows, *plane, options.tolerance);
}

SampleRows removeBackground(SampleRows rows, const BackgroundOptions& options) {
  const auto plane = findBackground(rows, options);
  if (!plane) return rows;
  std::vector<RowPiece> pieces = std::move(rows.pieces);
  rows.pieces.clear();
  for (const RowPiece& piece : pieces) keepAbove(piece, *plane, options, rows);
  if (rows.pieces.empty()) {
    throw InputError("scan cloud", "number of samples above the background", "0",
                     "some: without a table set scan.background.mode=none");
  }
  return rows;
}

}  // namespace scan_to_path::scan
