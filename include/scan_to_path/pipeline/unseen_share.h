// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scan_to_path/scan/no_returns.h"
#include "scan_to_path/scan/sample_rows.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path::pipeline {

/// How much of the part's rows was not seen as part: holes, and relief beyond the sensor's range. Shares of the length
/// of the rows from the part's first to its last sample on each, and of what lies beyond the range beside.
struct UnseenShare {
  double too_near = 0.0;   ///< nearer than the sensor sees, inside the rows or beside them
  double too_far = 0.0;    ///< farther than the sensor sees, inside the rows or beside them
  double no_return = 0.0;  ///< inside the rows, no sample there for another reason or for none that can be told
  double other = 0.0;      ///< inside the rows, samples that are not the part's: table, spikes, short pieces

  double sum() const { return too_near + too_far + no_return + other; }
};

/// Gaps longer than `shortest_gap` [m] on the rows of cleanRows of `cloud`, rows that are missing between two others
/// (where these are more than 2.5 times as far apart as three quarters of all neighbours are), and beams without a
/// return where the part goes on beyond the range (lengthsBeyondRange; none are known of a cloud that was read).
UnseenShare unseenShare(const scan::ScanCloud& cloud, const scan::SampleRows& rows, const scan::NoReturns& no_returns,
                        double shortest_gap);

/// What to tell the user when the share is above the limit, and from which side to sweep again.
std::optional<std::string> unseenNote(const UnseenShare& share, double limit);

}  // namespace scan_to_path::pipeline
