// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/between_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "line_table.h"
#include "row_neighbours.h"

namespace scan_to_path::scan {
namespace {

/// Value at y of the cubic through four points (y, z).
double cubicThrough(const Vector3 (&p)[4], double y) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    double weight = 1.0;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j != i) weight *= (y - p[j].y()) / (p[i].y() - p[j].y());
    }
    sum += weight * p[i].z();
  }
  return sum;
}

/// How far a row's points lie off the cubics through rows at steps -2 k, -k, k and 2 k.
class RowPrediction {
public:
  RowPrediction(const ScanTables& tables, int row) : neighbours_(tables, row, 0.0) {}

  /// z less its prediction; nothing where a row does not pass x.
  std::optional<double> error(const Vector3& point, int k) {
    Vector3 around[4];
    const int steps[4] = {-2 * k, -k, k, 2 * k};
    for (std::size_t i = 0; i < 4; ++i) {
      if (!neighbours_.lineAt(steps[i], point.x())) return std::nullopt;
      around[i] = neighbours_.pointAt(steps[i], point.x());
    }
    if (k == 1) slope_ = (around[2].z() - around[1].z()) / (around[2].y() - around[1].y());
    return point.z() - cubicThrough(around, point.y());
  }

  /// Whether this row is one of five neighbouring ones that pass x, so that they say something about its surroundings.
  bool isCovered(double x) {
    int rows = 1;
    for (const int way : {-1, 1}) {
      for (int step = way; std::abs(step) < stencil && neighbours_.lineAt(step, x); step += way) ++rows;
    }
    return rows >= stencil;
  }

  /// dz/dy between the next rows; of the last error with k = 1.
  double slope() const { return slope_; }

private:
  static constexpr int stencil = 5;
  static_assert(stencil - 1 <= RowNeighbours::reach);
  RowNeighbours neighbours_;
  double slope_ = 0.0;
};

/// What remains half way between two rows of an error `own` on a row, by the order in which it grew from the error of
/// twice the distance.
double halfWay(double own, std::optional<double> doubled) {
  constexpr double per_order = 0.6124;  // (9/64)^(1/4): see BetweenRows
  double order = 1.0;
  if (doubled) order = std::clamp(std::log2(std::max(std::abs(*doubled), 1e-12) / std::max(own, 1e-12)), 0.0, 4.0);
  return own * std::pow(per_order, order);
}

}  // namespace

BetweenRows estimateBetweenRows(const FittedScan& scan) {
  BetweenRows result;
  if (!(scan.pitch > 0.0)) return result;
  const ScanTables tables = makeTables(scan);
  double squares = 0.0;
  std::size_t looked_at = 0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < tables.lines.size(); ++i) {
    const LineTable& line = tables.lines[i];
    RowPrediction prediction(tables, scan.lines[i].row);
    const auto count = static_cast<std::size_t>((line.xEnd() - line.xBegin()) / (0.25 * scan.pitch));
    double u = line.begin();
    std::size_t hint = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double x = line.xBegin() + (static_cast<double>(k) + 0.5) * 0.25 * scan.pitch;
      const Vector3 point = line.pointAtX(x, u, hint);
      ++looked_at;
      if (prediction.isCovered(x)) ++covered;
      const std::optional<double> own = prediction.error(point, 1);
      if (!own) continue;
      const Vector3 along = line.jet(u, hint).first;
      const double slope = along.z() / along.x();
      const double off_vertical = std::sqrt(1.0 + slope * slope + prediction.slope() * prediction.slope());
      const double off = halfWay(std::abs(*own), prediction.error(point, 2)) / off_vertical;
      squares += off * off;
      result.largest = std::max(result.largest, off);
      ++result.points;
    }
  }
  if (looked_at > 0) result.share = static_cast<double>(covered) / static_cast<double>(looked_at);
  if (result.points > 0) result.rms = std::sqrt(squares / static_cast<double>(result.points));
  return result;
}

}  // namespace scan_to_path::scan
