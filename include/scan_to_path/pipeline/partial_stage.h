// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/pipeline/stages.h"

namespace scan_to_path::pipeline {

/// What is left of a path on which waypoints fail, once all that fails is left out.
struct PartialStage {
  PathStage path;      ///< on the part; the whole path when nothing fails there, or when there is no partial one
  PathStage driven;    ///< airRun of it
  MotionStage motion;  ///< along `driven`; verdicts are those on the part when there is no partial path
  std::vector<LeftOut> left_out;
  double left_out_share = 0.0;  ///< of the whole path's cutting length
  std::string refusal;          ///< why no program may be written; empty: none of the waypoints fails
};

/// Leaves out the contacts that fail, whatever their verdict, has the planner cut the rows there and make leads and
/// links anew (nothing is ever joined straight across a gap), plans the motion again, and repeats that until nothing
/// fails. Where a lead or a link fails, the row that it leads to or comes from is shortened at that end, first by
/// an eighth of the planner's shortest piece, then by twice as much each time, and dropped when less than a piece is
/// left. What is left out is decided on the part, also for an air run, which so rehearses the very path that the real
/// program drives; an air run that then fails is refused. `motion` is the whole path's, along airRun of it.
PartialStage partialStage(const process::Planner& planner, const PathStage& whole, const MotionStage& motion,
                          const scan::FittedScan& scan, const Cell& cell, const JobOptions& options,
                          const Progress& progress);

}  // namespace scan_to_path::pipeline
