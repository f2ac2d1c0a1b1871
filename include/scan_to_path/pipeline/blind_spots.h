// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::pipeline {

/// A place inside the part's rows of which there is no sample at all, of the part or of anything else: a hole, or
/// something that the sensor did not see or the log does not hold.
struct BlindSpot {
  double length = 0.0;                                   ///< along the rows [m]
  double width = 0.0;                                    ///< across, rows times their usual distance [m]
  geometry::Vector3 middle = geometry::Vector3::Zero();  ///< in the scan cloud's frame, at the height around it [m]
};

/// Gaps longer than `shortest_gap` [m] between a row's first and last sample of the part, less what else was sampled
/// there; those of neighbouring rows that overlap are one spot. The largest first.
std::vector<BlindSpot> blindSpots(const scan::SampleRows& rows, double shortest_gap);

/// What to tell the user: how many, and where the largest is.
std::optional<std::string> blindSpotNote(const std::vector<BlindSpot>& spots);

}  // namespace scan_to_path::pipeline
