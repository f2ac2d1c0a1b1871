// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::pipeline {

/// How much of the part's rows, from the first to the last sample of the part on each, was not seen as part: a hole, or
/// relief beyond the sensor's range. Shares of the rows' whole length.
struct UnseenShare {
  double no_return = 0.0;  ///< no sample there
  double other = 0.0;      ///< samples that are not the part's: table, spikes, short pieces

  double sum() const { return no_return + other; }
};

/// Gaps longer than `shortest_gap` [m] on the rows of cleanRows, and rows that are missing between two others: where
/// these are more than 2.5 times as far apart as three quarters of all neighbours are.
UnseenShare unseenShare(const scan::SampleRows& rows, double shortest_gap);

/// What to tell the user when the share is above the limit.
std::optional<std::string> unseenNote(const UnseenShare& share, double limit);

}  // namespace scan_to_path::pipeline
