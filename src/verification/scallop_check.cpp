// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/scallop_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/parallel.h"

namespace scan_to_path::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The ball's centre on one worked move.
struct Move {
  Vector3 a;
  Vector3 b;
};

std::vector<Move> workedMoves(const toolpath::ToolPath& path, double radius) {
  const Vector3 centre(0.0, 0.0, radius);
  std::vector<Move> moves;
  for (const auto& segment : path.segments) {
    for (std::size_t i = 1; i < segment.waypoints.size(); ++i) {
      if (!segment.waypoints[i].process_on) continue;
      moves.push_back({segment.waypoints[i - 1].pose * centre, segment.waypoints[i].pose * centre});
    }
  }
  return moves;
}

/// Height over q along n at which a line comes into the ball round c; infinite when it passes.
double ballEntry(const Vector3& q, const Vector3& n, const Vector3& c, double radius) {
  const Vector3 d = c - q;
  const double along = d.dot(n);
  const double discriminant = along * along - d.squaredNorm() + radius * radius;
  return discriminant >= 0.0 && along > 0.0 ? along - std::sqrt(discriminant) : infinity;
}

/// The same for the round wall between the move's two end balls.
double wallEntry(const Vector3& q, const Vector3& n, const Move& move, double radius) {
  const Vector3 axis = move.b - move.a;
  const double length2 = axis.squaredNorm();
  if (!(length2 > 0.0)) return infinity;
  const Vector3 d = move.a - q;
  const Vector3 n_flat = n - axis * (n.dot(axis) / length2);
  const Vector3 d_flat = d - axis * (d.dot(axis) / length2);
  const double n2 = n_flat.squaredNorm();
  const double along = d_flat.dot(n_flat);
  const double discriminant = along * along - n2 * (d_flat.squaredNorm() - radius * radius);
  if (!(n2 > 0.0 && discriminant >= 0.0 && along > 0.0)) return infinity;
  const double height = (along - std::sqrt(discriminant)) / n2;
  const double share = (height * n - d).dot(axis) / length2;
  return share >= 0.0 && share <= 1.0 ? height : infinity;
}

double entry(const Vector3& q, const Vector3& n, const Move& move, double radius) {
  return std::min({ballEntry(q, n, move.a, radius), ballEntry(q, n, move.b, radius), wallEntry(q, n, move, radius)});
}

/// Boxes around halves, quarters, … of the moves in their order, which keeps neighbours together.
class MoveTree {
public:
  explicit MoveTree(const std::vector<Move>& moves) : moves_(moves), boxes_(2 * moves.size()) {
    build(0, 0, moves_.size());
  }

  /// The least entry up to `limit` of all moves; infinite when there is none.
  double lowestEntry(const Vector3& q, const Vector3& n, double radius, double limit) const {
    double lowest = infinity;
    search(0, 0, moves_.size(), q, n, radius, limit, lowest);
    return lowest;
  }

private:
  static constexpr std::size_t leaf_size = 4;

  // Node i of [begin, end) has its left half at i + 1 and its right half after all of the left's nodes.
  std::size_t rightNode(std::size_t node, std::size_t left_size) const { return node + 2 * left_size; }

  Eigen::AlignedBox3d build(std::size_t node, std::size_t begin, std::size_t end) {
    Eigen::AlignedBox3d box;
    if (end - begin <= leaf_size) {
      for (std::size_t i = begin; i < end; ++i) box.extend(moves_[i].a).extend(moves_[i].b);
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      box = build(node + 1, begin, middle).merged(build(rightNode(node, middle - begin), middle, end));
    }
    boxes_[node] = box;
    return box;
  }

  /// A move that cuts at height h over q has its centre within r + h of q.
  void search(std::size_t node, std::size_t begin, std::size_t end, const Vector3& q, const Vector3& n, double radius,
              double limit, double& lowest) const {
    const double reach = radius + std::clamp(lowest, 0.0, limit);
    if (boxes_[node].squaredExteriorDistance(q) > reach * reach) return;
    if (end - begin <= leaf_size) {
      for (std::size_t i = begin; i < end; ++i) {
        const double height = entry(q, n, moves_[i], radius);
        if (height <= limit) lowest = std::min(lowest, height);
      }
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const std::size_t left = node + 1;
    const std::size_t right = rightNode(node, middle - begin);
    // The nearer half first: what it finds often spares the other one.
    const bool is_left_first = boxes_[left].squaredExteriorDistance(q) <= boxes_[right].squaredExteriorDistance(q);
    if (is_left_first) search(left, begin, middle, q, n, radius, limit, lowest);
    search(right, middle, end, q, n, radius, limit, lowest);
    if (!is_left_first) search(left, begin, middle, q, n, radius, limit, lowest);
  }

  const std::vector<Move>& moves_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

void checkArguments(double ball_radius, double limit, std::size_t moves) {
  if (!(ball_radius > 0.0) || !std::isfinite(ball_radius)) {
    throw InputError("scallop check", "ball radius", std::to_string(ball_radius) + " m", "positive");
  }
  if (!(limit > 0.0) || !std::isfinite(limit)) {
    throw InputError("scallop check", "limit", std::to_string(limit) + " m", "positive");
  }
  if (moves == 0) throw InputError("scallop check: no move of the path works");
}

void addDistribution(ScallopReport& report) {
  std::vector<double> sorted;
  for (const double height : report.heights) {
    if (!std::isnan(height)) sorted.push_back(height);
  }
  report.uncut = report.points - sorted.size();
  if (sorted.empty()) return;
  std::sort(sorted.begin(), sorted.end());
  double sum = 0.0;
  for (const double height : sorted) sum += height;
  report.mean = sum / static_cast<double>(sorted.size());
  report.median = sorted[sorted.size() / 2];
  report.percentile_95 = sorted[sorted.size() * 95 / 100];
}

void addExtremes(ScallopReport& report, const std::vector<SurfacePoint>& points) {
  report.highest = -infinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double height = report.heights[i];
    if (height > report.highest) {
      report.highest = height;
      report.highest_at = points[i].point;
    }
    if (-height > report.deepest_cut) {
      report.deepest_cut = -height;
      report.deepest_at = points[i].point;
    }
  }
  if (report.highest == -infinity) report.highest = 0.0;
}

}  // namespace

std::vector<SurfacePoint> sampleSurface(const geometry::Surface& surface, const SampleGrid& grid) {
  if (!(grid.spacing_x > 0.0 && grid.spacing_y > 0.0 && grid.x_max >= grid.x_min && grid.y_max >= grid.y_min)) {
    throw InputError("surface samples: spacing must be positive and ranges must not be empty");
  }
  const auto columns = static_cast<std::size_t>(std::floor((grid.x_max - grid.x_min) / grid.spacing_x + 1e-9)) + 1;
  const auto rows = static_cast<std::size_t>(std::floor((grid.y_max - grid.y_min) / grid.spacing_y + 1e-9)) + 1;
  std::vector<SurfacePoint> points;
  points.reserve(columns * rows);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const Vector3 origin(grid.x_min + static_cast<double>(i) * grid.spacing_x,
                           grid.y_min + static_cast<double>(j) * grid.spacing_y, 0.0);
      const auto hit = surface.castRay({grid.T_surface_grid * origin, -grid.T_surface_grid.linear().col(2)});
      if (hit) points.push_back({hit->point, hit->normal});
    }
  }
  return points;
}

ScallopReport checkScallops(const toolpath::ToolPath& path, double ball_radius, const std::vector<SurfacePoint>& points,
                            double limit, int threads) {
  const std::vector<Move> moves = workedMoves(path, ball_radius);
  checkArguments(ball_radius, limit, moves.size());
  const MoveTree tree(moves);
  ScallopReport report;
  report.points = points.size();
  report.heights.assign(points.size(), std::nan(""));
  parallelFor(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double height = tree.lowestEntry(points[i].point, points[i].normal, ball_radius, limit);
      if (height < infinity) report.heights[i] = height;
    }
  });
  addDistribution(report);
  addExtremes(report, points);
  return report;
}

}  // namespace scan_to_path::verification
