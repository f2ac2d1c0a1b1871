// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/motion/motion_plan.h"
#include "scan_to_path/pipeline/report.h"

namespace scan_to_path::pipeline {

/// What to say of moves that are over before a controller has worked out the next one.
struct ShortMoves {
  std::vector<Accuracy> accuracy;   ///< short_moves, their number; with any, shortest_move [s]
  std::optional<std::string> note;  ///< nothing when no move is short
};

/// Looks at the moves of a program, from each waypoint that has joint angles to the next one, for those that last less
/// than `shortest` [s] (motion.shortest_move_time).
ShortMoves shortMoves(const toolpath::ToolPath& path, const motion::Trajectory& trajectory, double shortest);

}  // namespace scan_to_path::pipeline
