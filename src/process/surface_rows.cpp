// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/surface_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "row_maker.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/process/row_plan.h"
#include "scan_to_path/process/row_scallop.h"

namespace scan_to_path::process {
namespace {

constexpr double least_share = 0.93;  // of the scallop height that a step uses, but for the last one, …
constexpr double aimed_share = 0.97;  // … that it aims at …
constexpr double most_share = 0.995;  // … and that it may reach, for what lies between the places looked at
constexpr int most_rows = 10000;      // a part of 1 m at 0.1 mm; more take minutes and gigabytes
constexpr int most_trials = 20;       // per row; the secant needs one to three

struct NextRow {
  double s = 0.0;
  std::vector<Row> rows;
  double scallop = 0.0;
};

/// The row at s and what it leaves next to the one before.
NextRow rowAt(const RowMaker& maker, const std::vector<Row>& before, double s, int number,
              const CuttingOptions& options) {
  NextRow next;
  next.s = s;
  next.rows = maker.rowsAt(s, number);
  next.scallop = widestScallop(before, next.rows, maker.surface(), options.ball_radius).value_or(0.0);
  return next;
}

/// The next row as far away as the scallop height allows, by trial: a scallop grows with the distance squared.
NextRow nextByScallop(const RowMaker& maker, const std::vector<Row>& before, double s, double last, int number,
                      const CuttingOptions& options) {
  const double h = options.scallop_height;
  double step = maker.ruleDistance(before);
  double allowed = 0.0;
  double too_far = std::numeric_limits<double>::infinity();
  NextRow next;
  for (int trial = 0; trial < most_trials; ++trial) {
    NextRow tried = rowAt(maker, before, std::min(s + step, last), number, options);
    const double scallop = tried.scallop;
    const bool is_enough = scallop >= least_share * h || scallop == 0.0 || tried.s >= last;
    if (scallop <= most_share * h) {
      allowed = step;
      next = std::move(tried);
      if (is_enough) return next;
    } else {
      too_far = step;
    }
    const double factor = std::sqrt(aimed_share * h / std::max(scallop, 0.1 * h));
    step *= std::clamp(factor, 0.3, 2.0);
    if (step <= allowed || step >= too_far) step = std::isfinite(too_far) ? 0.5 * (allowed + too_far) : 2.0 * allowed;
  }
  if (allowed > 0.0) return next;
  // Only next to a gouge does no distance help; the rule, which leaves such places out, goes on from there.
  return rowAt(maker, before, std::min(s + maker.ruleDistance(before), last), number, options);
}

void checkRowCount(double count, const CuttingOptions& options) {
  if (count <= most_rows) return;
  const bool by_pitch = options.pitch > 0.0;
  const std::string value = fixed(1e6 * (by_pitch ? options.pitch : options.scallop_height), 3);
  throw InputError(std::string("path.") + (by_pitch ? "pitch" : "scallop_height") + " of " + value + " um",
                   "number of rows", fixed(std::ceil(count), 0), "at most " + std::to_string(most_rows));
}

/// What of the whole part's rows is driven.
RowPlan chosenRows(const RowMaker& maker, const RowPlan& whole, const CuttingOptions& options,
                   const toolpath::Region& region) {
  std::vector<int> numbers;
  std::vector<Row> pieces;
  for (const Row& row : whole.rows) {
    if (numbers.empty() || numbers.back() != row.row) numbers.push_back(row.row);
    for (Row& piece : maker.inRegion(row, region)) pieces.push_back(std::move(piece));
  }
  return planOf(withoutSkipped(std::move(pieces), options.skip_rows), numbers, whole.rows, maker.across(),
                maker.surface(), options.ball_radius);
}

}  // namespace

RowPlan surfaceRows(const scan::FittedScan& scan, const CuttingOptions& options, const Progress& progress,
                    const toolpath::Region& region) {
  const bool takes_all = region.isEverything() && options.skip_rows.empty();
  const RowMaker maker(scan, options);
  const double first = maker.edge(1);
  const double last = maker.edge(-1);
  checkRowCount((last - first) / (options.pitch > 0.0 ? options.pitch : maker.planeDistance()), options);
  RowPlan plan;
  int number = 0;
  std::vector<Row> before = maker.rowsAt(first, number);
  plan.rows = before;
  for (double s = first; s < last;) {
    progress.update("path", (s - first) / (last - first));
    checkRowCount(++number, options);
    NextRow next = options.pitch > 0.0 ? rowAt(maker, before, std::min(s + options.pitch, last), number, options)
                                       : nextByScallop(maker, before, s, last, number, options);
    if (takes_all) checkThatBallsMeet(next.scallop, number, options.ball_radius);
    plan.distances.push_back(next.s - s);
    plan.widest_scallop = std::max(plan.widest_scallop, next.scallop);
    plan.rows.insert(plan.rows.end(), next.rows.begin(), next.rows.end());
    s = next.s;
    before = std::move(next.rows);
  }
  plan.last_row = number;
  return takes_all ? plan : chosenRows(maker, plan, options, region);
}

}  // namespace scan_to_path::process
