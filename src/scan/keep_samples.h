// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace scan_to_path::scan {

/// Keeps the samples for whose number `keep` is true, in their order, in columns x, y, z and index (a RowPiece, a
/// Track). Returns how many went.
template <class Columns, class Keep>
std::size_t keepSamples(Columns& columns, Keep&& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!keep(i)) continue;
    columns.x[kept] = columns.x[i];
    columns.y[kept] = columns.y[i];
    columns.z[kept] = columns.z[i];
    columns.index[kept++] = columns.index[i];
  }
  const std::size_t removed = columns.size() - kept;
  columns.x.resize(kept);
  columns.y.resize(kept);
  columns.z.resize(kept);
  columns.index.resize(kept);
  return removed;
}

}  // namespace scan_to_path::scan
