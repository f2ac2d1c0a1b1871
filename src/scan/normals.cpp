// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/normals.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "cross_stencil.h"
#include "row_neighbours.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/parallel.h"
#include "scan_to_path/nurbs/height_surface.h"

namespace scan_to_path::scan {
namespace {

/// The derivative across the rows along one line. Weights are kept while the same rows are there and have not moved.
class CrossDerivative {
public:
  CrossDerivative(const ScanTables& tables, int row, double pitch)
      : neighbours_(tables, row, margin * pitch), pitch_(pitch) {}

  /// A vector along the surface in the plane x = const through p, towards +y; zero without a neighbouring row.
  Vector3 at(const Vector3& p) {
    if (!(p.x() <= valid_until_)) choose(p);
    Vector3 derivative = Vector3::Zero();
    for (std::size_t k = 0; k < stencil_.count; ++k) {
      if (stencil_.step[k] != 0) derivative += stencil_.weight[k] * (neighbours_.pointAt(stencil_.step[k], p.x()) - p);
    }
    return derivative;
  }

private:
  static constexpr double margin = 0.05;      // of the pitch: how far a neighbour may be extrapolated
  static constexpr double renewal = 0.5;      // of the pitch: rows wander little over that
  static constexpr double sharp_bend = 0.35;  // rad between the slopes to both sides of a row

  struct Side {
    std::array<StencilRow, RowNeighbours::reach> rows;
    std::array<double, RowNeighbours::reach> slope{};  ///< angle of the surface from the row before to this one
    std::size_t count = 0;
  };

  Side side(const Vector3& p, int sense) {
    Side found;
    Vector3 last = p;
    for (int k = 1; k <= RowNeighbours::reach; ++k) {
      const int step = sense * k;
      if (!neighbours_.lineAt(step, p.x())) break;
      const Vector3 q = neighbours_.pointAt(step, p.x());
      const double slope = std::atan2(sense * (q.z() - last.z()), sense * (q.y() - last.y()));
      if (found.count > 0 && std::abs(slope - found.slope[found.count - 1]) > sharp_bend) break;
      found.slope[found.count] = slope;
      found.rows[found.count++] = {step, q.y() - p.y(), neighbours_.direction(step)};
      last = q;
    }
    return found;
  }

  /// Rows on both sides of a sharp bend do not share a tangent: the side that goes on straight is the point's own.
  static void keepSmootherSide(Side& below, Side& above) {
    if (below.count == 0 || above.count == 0 || std::abs(below.slope[0] - above.slope[0]) <= sharp_bend) return;
    const auto roughness = [](const Side& side) {
      return side.count < 2 ? 10.0 : std::abs(side.slope[1] - side.slope[0]);
    };
    (roughness(below) <= roughness(above) ? above : below).count = 0;
  }

  void choose(const Vector3& p) {
    neighbours_.resetValid();
    Side below = side(p, -1);
    Side above = side(p, +1);
    keepSmootherSide(below, above);
    stencil_ = crossStencil({0, 0.0, neighbours_.direction(0)}, below.rows.data(), below.count, above.rows.data(),
                            above.count);
    valid_until_ = std::min(neighbours_.validUntil(), p.x() + renewal * pitch_);
  }

  RowNeighbours neighbours_;
  double pitch_;
  double valid_until_ = -1e300;
  CrossStencil stencil_;
};

/// The seed's four triangles (eqs. 8-10), as their area-weighted sum turned to the sensor; zero without a neighbour.
Vector3 triangleNormal(const Vector3& p, const Vector3* before, const Vector3* after, const Vector3* below,
                       const Vector3* above) {
  Vector3 sum = Vector3::Zero();
  const auto add = [&](const Vector3* a, const Vector3* b) {
    if (a == nullptr || b == nullptr) return;
    const Vector3 cross = (*a - p).cross(*b - p);
    sum += cross.z() < 0.0 ? Vector3(-cross) : cross;
  };
  add(after, above);
  add(above, before);
  add(before, below);
  add(below, after);
  return sum;
}

inline OrientedPoint orientedPoint(const LineTable::Jet& jet, const Vector3& normal, double u,
                                   const Frame& T_cloud_scan) {
  const Eigen::Matrix3d R = T_cloud_scan.linear();
  return {R * jet.point + T_cloud_scan.translation(), R * (normal * (1.0 / normal.norm())),
          R * (jet.first * (1.0 / jet.first.norm())), u};
}

void orientWeighted(const ScanTables& tables, int row, double pitch, const LineTable& line, const Frame& T_cloud_scan,
                    const std::vector<double>& parameters, std::vector<OrientedPoint>& points) {
  CrossDerivative across(tables, row, pitch);
  std::size_t hint = 0;
  for (const double u : parameters) {
    const LineTable::Jet jet = line.jet(u, hint);
    const Vector3 normal = jet.first.cross(across.at(jet.point));
    if (normal.z() > 0.0) points.push_back(orientedPoint(jet, normal, u, T_cloud_scan));
  }
}

void orientAsSeed(const ScanTables& tables, int row, double pitch, const LineTable& line, const Frame& T_cloud_scan,
                  const std::vector<double>& parameters, std::vector<OrientedPoint>& points) {
  RowNeighbours neighbours(tables, row, 0.05 * pitch);
  std::size_t hint = 0;
  Vector3 before = Vector3::Zero();
  LineTable::Jet jet = parameters.empty() ? LineTable::Jet() : line.jet(parameters[0], hint);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const bool last = k + 1 == parameters.size();
    const LineTable::Jet next = last ? jet : line.jet(parameters[k + 1], hint);
    std::array<Vector3, 2> sides;
    const auto nearest = [&](int step) -> const Vector3* {
      if (!neighbours.lineAt(step, jet.point.x())) return nullptr;
      Vector3& place = sides[step < 0 ? 0 : 1];
      place = neighbours.nearestTo(step, jet.point);
      return &place;
    };
    const Vector3* below = nearest(-1);
    const Vector3* above = nearest(+1);
    const Vector3 normal =
        triangleNormal(jet.point, k > 0 ? &before : nullptr, last ? nullptr : &next.point, below, above);
    if (normal.z() > 0.0) points.push_back(orientedPoint(jet, normal, parameters[k], T_cloud_scan));
    before = jet.point;
    jet = next;
  }
}

void orientOnSurface(const nurbs::HeightSurface& surface, const LineTable& line, const Frame& T_cloud_scan,
                     const std::vector<double>& parameters, std::vector<OrientedPoint>& points) {
  std::size_t hint = 0;
  for (const double u : parameters) {
    const LineTable::Jet jet = line.jet(u, hint);
    const Vector3 normal = nurbs::heightNormal(surface.at(jet.point.x(), jet.point.y()));
    points.push_back(orientedPoint(jet, normal, u, T_cloud_scan));
  }
}

}  // namespace

struct NormalEstimator::Data {
  NormalMode mode;
  ScanTables tables;
  std::vector<int> rows;
  nurbs::HeightSurface surface;
  Frame T_cloud_scan;
  double pitch;
};

NormalEstimator::NormalEstimator(const FittedScan& scan, NormalMode mode) {
  if (mode == NormalMode::surface && scan.surface.control_points.empty()) {
    throw InputError("normals", "fitted surface", "missing", "there for normals of mode surface");
  }
  std::vector<int> rows;
  for (const FittedLine& line : scan.lines) rows.push_back(line.row);
  data_ = std::make_unique<const Data>(
      Data{mode, makeTables(scan), std::move(rows),
           mode == NormalMode::surface ? nurbs::HeightSurface(scan.surface) : nurbs::HeightSurface(), scan.T_cloud_scan,
           scan.pitch});
}

NormalEstimator::~NormalEstimator() = default;
NormalEstimator::NormalEstimator(NormalEstimator&&) noexcept = default;

OrientedLine NormalEstimator::orient(int line, const std::vector<double>& parameters) const {
  const auto index = static_cast<std::size_t>(line);
  if (line < 0 || index >= data_->tables.lines.size()) {
    throw InputError("normals", "line", std::to_string(line),
                     "in [0, " + std::to_string(data_->tables.lines.size()) + ")");
  }
  OrientedLine oriented;
  oriented.line = line;
  oriented.points.reserve(parameters.size());
  const LineTable& table = data_->tables.lines[index];
  const int row = data_->rows[index];
  switch (data_->mode) {
    case NormalMode::weighted:
      orientWeighted(data_->tables, row, data_->pitch, table, data_->T_cloud_scan, parameters, oriented.points);
      break;
    case NormalMode::seed:
      orientAsSeed(data_->tables, row, data_->pitch, table, data_->T_cloud_scan, parameters, oriented.points);
      break;
    case NormalMode::surface:
      orientOnSurface(data_->surface, table, data_->T_cloud_scan, parameters, oriented.points);
      break;
  }
  return oriented;
}

OrientedScan orientLines(const FittedScan& scan, const ResampleOptions& resample, NormalMode mode, int threads) {
  const NormalEstimator estimator(scan, mode);
  std::vector<OrientedLine> lines(scan.lines.size());
  std::vector<std::size_t> lost(lines.size(), 0);
  parallelFor(lines.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<double> parameters = resampleParameters(scan.lines[i], resample);
      lines[i] = estimator.orient(static_cast<int>(i), parameters);
      lost[i] = parameters.size() - lines[i].points.size();
    }
  });
  OrientedScan oriented;
  std::size_t without = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    without += lost[i];
    if (!lines[i].points.empty()) oriented.lines.push_back(std::move(lines[i]));
  }
  if (without > 0) oriented.dropped.push_back({"no neighbouring row", without});
  return oriented;
}

}  // namespace scan_to_path::scan
