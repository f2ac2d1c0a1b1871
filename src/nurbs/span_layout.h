// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "scan_to_path/nurbs/knot_vector.h"

namespace scan_to_path::nurbs {

/// Basis on a span between the given ends; beyond the first and last end knots repeat them.
inline CubicSpanMatrix spanMatrix(const std::vector<int>& ends, int span) {
  double knots[6];
  const int last = static_cast<int>(ends.size()) - 1;
  for (int j = 0; j < 6; ++j) knots[j] = ends[static_cast<std::size_t>(std::clamp(span - 2 + j, 0, last))];
  return cubicSpanMatrix(knots);
}

/// Ends of nearly uniform spans on the block grid, the same from either end .
inline std::vector<int> spanEnds(int spans, int blocks) {
  std::vector<int> ends(static_cast<std::size_t>(spans) + 1);
  for (int k = 0; 2 * k <= spans; ++k) {
    const int end = static_cast<int>((2LL * k * blocks + spans) / (2LL * spans));
    ends[static_cast<std::size_t>(k)] = end;
    ends[static_cast<std::size_t>(spans - k)] = blocks - end;
  }
  return ends;
}

/// Clamped cubic knots of the spans that end at `ends`, on a grid of `blocks` blocks from first to last.
inline std::vector<double> cubicKnots(const std::vector<int>& ends, int blocks, double first, double last) {
  std::vector<double> knots(3, first);
  for (const int end : ends) knots.push_back(first + (last - first) * (static_cast<double>(end) / blocks));
  knots.back() = last;
  knots.insert(knots.end(), 3, last);
  return knots;
}

/// Precondition: n >= 1.
inline std::size_t powerOfTwoAtMost(std::size_t n) {
  std::size_t power = 1;
  while (2 * power <= n) power *= 2;
  return power;
}

}  // namespace scan_to_path::nurbs
