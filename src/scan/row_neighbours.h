// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "line_table.h"

namespace scan_to_path::scan {

/// The rows around one line, followed along it. Points must come with rising x, else it costs more than O(1) each.
class RowNeighbours {
public:
  static constexpr int reach = 4;

  /// `margin`: a neighbouring line may end this much before a point and still be its neighbour [m].
  RowNeighbours(const ScanTables& tables, int row, double margin);

  /// Number of the line of the row `step` away that passes x; nothing when there is none.
  std::optional<std::size_t> lineAt(int step, double x);

  /// Where that line passes x. Precondition: lineAt(step, x) found it last.
  Vector3 pointAt(int step, double x);

  /// The point of that line nearest to p. Same precondition for x = p.x().
  Vector3 nearestTo(int step, const Vector3& p);

  /// x up to which the last answers of lineAt stay the same [m].
  double validUntil() const { return valid_until_; }
  void resetValid() { valid_until_ = 1e300; }

  double direction(int step) const;

private:
  struct Cursor {
    std::size_t line = 0;
    std::size_t hint = 0;
    double u = 0.0;
    double x = 0.0;
    bool placed = false;
  };
  Cursor& cursor(int step) { return cursors_[static_cast<std::size_t>(step + reach)]; }
  void enterLine(Cursor& c);

  const ScanTables& tables_;
  int row_;
  double margin_;
  double valid_until_ = 1e300;
  std::array<Cursor, 2 * reach + 1> cursors_;
};

inline Vector3 RowNeighbours::pointAt(int step, double x) {
  Cursor& c = cursor(step);
  if (!c.placed) enterLine(c);
  c.u += x - c.x;  // exact where the parameter is x itself
  c.x = x;
  return tables_.lines[c.line].pointAtX(x, c.u, c.hint);
}

}  // namespace scan_to_path::scan
