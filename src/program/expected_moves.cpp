// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "expected_moves.h"

#include <algorithm>

namespace scan_to_path::program {

std::vector<ExpectedMove> expectedMoves(const ProgramInput& input) {
  std::vector<ExpectedMove> expected;
  const auto& points = input.plan.trajectory.points;
  std::size_t at = 0;
  for (int s = 0; s < static_cast<int>(input.path.segments.size()); ++s) {
    const auto& waypoints = input.path.segments[s].waypoints;
    for (int i = 0; i < static_cast<int>(waypoints.size()); ++i) {
      const JointVector* q = nullptr;
      for (; at < points.size() && points[at].segment == s && points[at].index == i; ++at) q = &points[at].q;
      expected.push_back({s, i, &waypoints[i], q});
    }
    const bool works =
        std::count_if(waypoints.begin(), waypoints.end(), [](const auto& w) { return w.process_on; }) > 0;
    for (auto at_row = expected.end() - static_cast<std::ptrdiff_t>(waypoints.size()); at_row != expected.end();
         ++at_row) {
      at_row->process_on = works;
    }
  }
  if (!expected.empty()) expected.front().process_on = false;  // an axis move leads there
  return expected;
}

}  // namespace scan_to_path::program
