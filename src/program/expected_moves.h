// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/program/program.h"

namespace scan_to_path::program {

/// A waypoint as the plan has it.
struct ExpectedMove {
  int segment = 0;
  int index = 0;
  const toolpath::Waypoint* waypoint = nullptr;
  const JointVector* q = nullptr;
  bool process_on = false;  ///< in a segment that works: before the tool touches until after it has left
};

/// The path's waypoints with their joint angles (null where the plan has none), in order. For the read-back: the writer
/// puts them together by itself, in planned_moves.h. Keeps pointers into the input.
std::vector<ExpectedMove> expectedMoves(const ProgramInput& input);

}  // namespace scan_to_path::program
