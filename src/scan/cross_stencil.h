// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace scan_to_path::scan {

/// A row's place in a difference across the rows.
struct StencilRow {
  int step = 0;            ///< row number less the point's own
  double offset = 0.0;     ///< y less the point's [m]
  double direction = 1.0;  ///< +1 measured towards +x, -1 the other way
};

constexpr std::size_t stencil_rows = 5;

/// Weights w of a first derivative across the rows [1/m].
struct CrossStencil {
  std::size_t count = 0;  ///< rows used; 0: no derivative
  std::array<int, stencil_rows> step{};
  std::array<double, stencil_rows> weight{};
};

/// Weights over `below` rows under and `above` rows over the point's own, each nearest first. Uses as many conditions
/// of NormalEstimator's list as there are rows for.
CrossStencil crossStencil(const StencilRow& own, const StencilRow* below, std::size_t below_count,
                          const StencilRow* above, std::size_t above_count);

}  // namespace scan_to_path::scan
