// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "row_neighbours.h"

#include <algorithm>

namespace scan_to_path::scan {

RowNeighbours::RowNeighbours(const ScanTables& tables, int row, double margin)
    : tables_(tables), row_(row), margin_(margin) {
  for (int step = -reach; step <= reach; ++step) {
    const int r = row + step;
    if (r >= 0 && r < tables.rowCount()) cursor(step).line = tables.row_first[static_cast<std::size_t>(r)];
  }
}

std::optional<std::size_t> RowNeighbours::lineAt(int step, double x) {
  const int r = row_ + step;
  if (r < 0 || r >= tables_.rowCount()) return std::nullopt;
  const std::size_t first = tables_.row_first[static_cast<std::size_t>(r)];
  const std::size_t last = tables_.row_first[static_cast<std::size_t>(r) + 1];
  Cursor& c = cursor(step);
  std::size_t line = c.line;
  while (line > first && x < tables_.lines[line].xBegin()) --line;
  while (line < last && x > tables_.lines[line].xEnd() + margin_) ++line;
  if (line != c.line) c.placed = false;
  if (line == last) return std::nullopt;
  c.line = line;
  const LineTable& table = tables_.lines[line];
  const double opens = table.xBegin() - margin_;
  if (x < opens) {
    valid_until_ = std::min(valid_until_, opens);
    return std::nullopt;
  }
  // Beyond its end the line is extrapolated only while the next one has not begun.
  const double closes = line + 1 < last
                            ? std::min(table.xEnd() + margin_, std::max(table.xEnd(), tables_.lines[line + 1].xBegin()))
                            : table.xEnd() + margin_;
  valid_until_ = std::min(valid_until_, closes);
  return line;
}

void RowNeighbours::enterLine(Cursor& c) {
  const LineTable& table = tables_.lines[c.line];
  c.u = table.begin();
  c.x = table.xBegin();
  c.hint = 0;
  c.placed = true;
}

Vector3 RowNeighbours::nearestTo(int step, const Vector3& p) {
  pointAt(step, p.x());
  const Cursor& c = cursor(step);
  const LineTable& table = tables_.lines[c.line];
  std::size_t hint = c.hint;
  double u = c.u;
  constexpr int newton_steps = 3;  // from the point at the same x; convergence is quadratic
  for (int k = 0; k < newton_steps; ++k) {
    const LineTable::Jet jet = table.jet(u, hint);
    const Vector3 off = jet.point - p;
    const double slope = jet.first.squaredNorm() + off.dot(jet.second);
    if (!(slope > 0.0)) break;
    u = std::clamp(u - off.dot(jet.first) / slope, table.begin(), table.end());
  }
  return table.point(u, hint);
}

double RowNeighbours::direction(int step) const {
  return tables_.row_forward[static_cast<std::size_t>(row_ + step)] != 0 ? 1.0 : -1.0;
}

}  // namespace scan_to_path::scan
