// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/row_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scan_to_path/common/error.h"
#include "scan_to_path/process/row_scallop.h"
#include "scan_to_path/toolpath/row_selection.h"

namespace scan_to_path::process {
namespace {

double meanAcross(const std::vector<Row>& pieces, const Eigen::Vector2d& across) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const Row& piece : pieces) {
    for (const RowPoint& p : piece.points) sum += across.dot(p.point.head<2>());
    count += piece.points.size();
  }
  return sum / static_cast<double>(count);
}

void numberPieces(std::vector<Row>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i].piece = static_cast<int>(i);
    row[i].pieces = static_cast<int>(row.size());
  }
}

/// Calls `take` with all pieces of each row.
template <class Take>
void forEachRow(const std::vector<Row>& pieces, Take take) {
  for (auto begin = pieces.begin(); begin != pieces.end();) {
    const auto end = std::find_if(begin, pieces.end(), [&](const Row& row) { return row.row != begin->row; });
    take(std::vector<Row>(begin, end));
    begin = end;
  }
}

std::vector<Row> rowOf(const std::vector<Row>& pieces, int number) {
  std::vector<Row> row;
  std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(row), [&](const Row& r) { return r.row == number; });
  return row;
}

}  // namespace

RowPlan planOf(const std::vector<Row>& pieces, const std::vector<int>& numbers, const std::vector<Row>& whole,
               const Eigen::Vector2d& across, const toolpath::ScanSurface& surface, double ball_radius) {
  RowPlan plan;
  plan.last_row = numbers.back();
  std::vector<Row> before;
  auto place = numbers.begin();
  forEachRow(pieces, [&](std::vector<Row> row) {
    numberPieces(row);
    const int number = row.front().row;
    place = std::lower_bound(place, numbers.end(), number);
    if (!before.empty() && *(place - 1) == before.front().row) {
      plan.distances.push_back(std::abs(meanAcross(row, across) - meanAcross(before, across)));
      const double scallop =
          widestScallopOfCut(before, row, rowOf(whole, before.front().row), rowOf(whole, number), surface, ball_radius)
              .value_or(0.0);
      checkThatBallsMeet(scallop, number, ball_radius);
      plan.widest_scallop = std::max(plan.widest_scallop, scallop);
    }
    plan.rows.insert(plan.rows.end(), row.begin(), row.end());
    before = std::move(row);
  });
  return plan;
}

std::vector<Row> withoutSkipped(std::vector<Row> pieces, const std::string& skip_rows) {
  const auto skipped = toolpath::RowSelection::parse(skip_rows, "path.skip_rows");
  if (pieces.empty()) throw InputError("cutting: no row lies in path.region");
  const int before = rowCount(pieces);
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), [&](const Row& row) { return skipped.contains(row.row); }),
               pieces.end());
  if (pieces.empty()) {
    throw InputError("path.skip_rows is \"" + skip_rows + "\": none of " + std::to_string(before) + " rows is left");
  }
  return pieces;
}

int rowCount(const std::vector<Row>& pieces) {
  int count = 0;
  forEachRow(pieces, [&](const std::vector<Row>&) { ++count; });
  return count;
}

}  // namespace scan_to_path::process
