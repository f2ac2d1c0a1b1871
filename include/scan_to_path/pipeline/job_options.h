// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/motion/plan_motion.h"
#include "scan_to_path/pipeline/cell.h"
#include "scan_to_path/process/cutting_options.h"
#include "scan_to_path/program/options.h"
#include "scan_to_path/scan/fit_scan.h"
#include "scan_to_path/sensing/clock_offset.h"
#include "scan_to_path/sensing/emulate_scan.h"
#include "scan_to_path/sensing/place_samples.h"

namespace scan_to_path::pipeline {

/// From samples or points to clean rows.
struct ScanSection {
  Vector3 beam = Vector3(0.0, 0.0, -1.0);
  sensing::PlacementOptions placement;
  bool correct_clock_offset = false;
  sensing::ClockOffsetOptions clock_offset;
  scan::ScanOptions cloud;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.beam,
          Field{"beam", "", "viewing direction of a cloud that does not bring one, in its own frame", -1.0, 1.0});
    visit(self.placement, Field{"placement"});
    visit(
        self.correct_clock_offset,
        Field{"correct_clock_offset", "", "place samples with the estimated offset of the clocks, not only report it"});
    visit(self.clock_offset, Field{"clock_offset"});
    std::decay_t<decltype(self.cloud)>::fields(self.cloud, visit);
  }
};

/// When a job that went through is still no success.
struct ReportOptions {
  double max_clock_offset = 2e-4;
  double max_unseen_jump = 1e-3;
  int max_unseen_pauses = 0;
  double max_dropped_share = 0.05;
  double max_line_residual = 1e-4;
  double max_surface_residual = 5e-5;
  double max_between_rows = 5e-5;
  double max_between_rows_unknown = 0.05;
  double max_unseen_share = 0.05;
  double note_unseen_share = 0.01;
  double max_reference_path = 2e-4;
  double max_reference_cut = 2e-4;
  double max_reference_scallop = 0.0;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.max_clock_offset,
          Field{"max_clock_offset", "s", "offset between the clocks that may be left uncorrected; 0: any", 0.0, 10.0});
    visit(self.max_unseen_jump,
          Field{"max_unseen_jump", "m",
                "that a joint's slip may move the sensor without being told from motion: see unseen_joint_jump; 0: any",
                0.0, 1.0});
    visit(self.max_unseen_pauses,
          Field{"max_unseen_pauses", "",
                "pauses of the joint readings in which the robot may be moved: rows recorded one by one need as many",
                0, 1000000});
    visit(self.max_dropped_share,
          Field{"max_dropped_share", "", "share of the part's samples that may be left out of the fit", 0.0, 1.0});
    visit(self.max_line_residual,
          Field{"max_line_residual", "m", "RMS of samples off the fitted lines; 0: no limit", 0.0, 1.0});
    visit(self.max_surface_residual,
          Field{"max_surface_residual", "m", "RMS of samples off the fitted surface, for rows on it; 0: no limit", 0.0,
                1.0});
    visit(self.max_between_rows, Field{"max_between_rows", "m",
                                       "RMS of what may be off between scan rows, for rows on the surface; scan finer, "
                                       "or use path.row_source scan_lines; 0: no limit",
                                       0.0, 1.0});
    visit(self.max_between_rows_unknown,
          Field{"max_between_rows_unknown", "",
                "share of the rows' length that may lie where fewer than five rows pass, so that max_between_rows says "
                "nothing of it",
                0.0, 1.0});
    visit(
        self.max_unseen_share,
        Field{"max_unseen_share", "",
              "share of the part's rows that may not be seen: see unseen_share; more where they are holes", 0.0, 1.0});
    visit(self.note_unseen_share,
          Field{"note_unseen_share", "", "a larger share of rows that was not seen is noted: see unseen_share", 0.0,
                1.0});
    visit(self.max_reference_path, Field{"max_reference_path", "m",
                                         "largest distance of the path from plan --reference; 0: no limit", 0.0, 1.0});
    visit(self.max_reference_cut,
          Field{"max_reference_cut", "m", "deepest cut into plan --reference; 0: no limit", 0.0, 1.0});
    visit(self.max_reference_scallop, Field{"max_reference_scallop", "m",
                                            "largest scallop left on plan --reference; 0: no limit, as rows along an "
                                            "edge leave more than path.scallop_height there",
                                            0.0, 1.0});
  }
};

/// Everything a configuration file may say.
struct JobOptions {
  CellOptions cell;
  ScanSection scan;
  scan::FitOptions fit;
  process::CuttingOptions path;
  motion::MotionOptions motion;
  program::ProgramOptions program;
  ReportOptions report;
  sensing::EmulationOptions emulate;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.cell, Field{"cell"});
    visit(self.scan, Field{"scan"});
    visit(self.fit, Field{"fit"});
    visit(self.path, Field{"path"});
    visit(self.motion, Field{"motion"});
    visit(self.program, Field{"program"});
    visit(self.report, Field{"report"});
    visit(self.emulate, Field{"emulate"});
  }
};

}  // namespace scan_to_path::pipeline
