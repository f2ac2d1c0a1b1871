// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/sensing/clock_offset.h"
#include "scan_to_path/sensing/offset_effect.h"

namespace scan_to_path::pipeline {

/// What a scan tells of the clocks' offset, and what of it the user must answer for.
struct ClockFindings {
  std::vector<Accuracy> accuracy;  ///< clock_offset_unknown, or clock_offset with its standard error and what is left
  std::vector<std::string> notes;
};

/// `effect` of options.clock_offset.largest_offset, where the estimate found too few slopes; `used` is the offset that
/// samples are placed with [s]. An offset that is stated is the user's to answer for: neither an estimate that there is
/// not nor a large standard error fails it, only an estimate that contradicts it.
ClockFindings clockFindings(const sensing::ClockOffsetEstimate& estimate,
                            const std::optional<sensing::OffsetEffect>& effect, const ScanSection& options, double used,
                            const ReportOptions& limits);

}  // namespace scan_to_path::pipeline
