// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/pipeline/stages.h"

namespace scan_to_path::pipeline {

/// What is left of a path on which waypoints fail, once all that fails is left out.
struct PartialStage {
  PathStage path;      ///< on the part; without segments when nothing could be driven
  MotionStage motion;  ///< along it, lifted in an air run; all waypoints are ok
  std::vector<LeftOut> left_out;
  double left_out_share = 0.0;  ///< of the whole path's cutting length
};

/// Leaves out the contacts that fail, whatever their verdict, has the planner cut the rows there and make leads and
/// links anew (nothing is ever joined straight across a gap), plans the motion again, and repeats that until nothing
/// fails. Where a lead or a link fails, the row that it leads to or comes from is shortened at that end, first by
/// an eighth of the planner's shortest piece, then by twice as much each time, and dropped when less than a piece is
/// left. `motion` is the whole path's, along airRun of it.
PartialStage partialStage(const process::Planner& planner, const PathStage& whole, const MotionStage& motion,
                          const scan::FittedScan& scan, const Cell& cell, const JobOptions& options,
                          const Progress& progress);

/// What is left out as lines for a program's header: the share, then a line for each stretch of a row, at most `most`.
std::vector<std::string> partialNotices(const std::vector<LeftOut>& left_out, double share, std::size_t most = 40);

}  // namespace scan_to_path::pipeline
