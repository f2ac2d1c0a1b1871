// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/background_findings.h"

#include <algorithm>

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

// A flange is less of a part than a table around it; what is nearly all of the scan is the part, and no table.
constexpr double least_flush = 0.2;
constexpr double most_flush = 0.95;

std::size_t backgroundCount(const scan::FittedScan& scan) {
  const auto background = std::find_if(scan.dropped.begin(), scan.dropped.end(),
                                       [](const auto& dropped) { return dropped.reason == "background"; });
  return background == scan.dropped.end() ? 0 : background->count;
}

}  // namespace

BackgroundFindings backgroundFindings(const scan::FittedScan& scan, const scan::SampleRows& rows,
                                      const scan::BackgroundOptions& options) {
  const std::size_t count = backgroundCount(scan), all = std::max<std::size_t>(scan.samples_in, 1);
  BackgroundFindings found;
  found.share = {"background_share", static_cast<double>(count) / static_cast<double>(all), "1"};
  // A plate with a pad on it looks like a table with a part on it.
  if (2 * count > scan.samples_in) {
    found.notes.push_back(std::to_string(count) + " of " + std::to_string(scan.samples_in) +
                          " samples were taken for a table behind the part: if it is the part itself, set "
                          "scan.background.mode=none");
  }
  const auto flush = scan::findFlushPlane(rows, options);
  if (flush && flush->share >= least_flush && flush->share <= most_flush) {
    found.notes.push_back(
        fixed(100.0 * flush->share, 1) +
        " % of the part is a plane around the rest, with no step between them: if it is the table, set "
        "scan.background.mode=height and scan.background.height=" +
        fixed(flush->height, 4) + ", if it is the part itself, scan.background.mode=none");
  }
  return found;
}

}  // namespace scan_to_path::pipeline
