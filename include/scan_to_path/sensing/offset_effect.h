// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/scan/sample_rows.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path::sensing {

/// How far a clock that is off could move a part's surface in height.
struct OffsetEffect {
  double height = 0.0;              ///< where it is largest [m]
  double noise = 0.0;               ///< standard deviation of such a height on a flat part, by the scan's own noise [m]
  Vector3 place = Vector3::Zero();  ///< where it is largest, in the cloud's frame [m]
};

/// The largest change of the part's height while the sensor travels for `offset` [s]: velocity times offset times slope
/// on a slope, the whole height of a step. Compares medians of stretches that follow each other in a row, each `offset`
/// long and of five samples at least, so that single spikes do not count; one row is enough. Steps between the pieces
/// of a row count, unless more than two stretches are missing between them, as over a hole: the part's edges are none
/// of its surface. `rows` are the cloud's clean ones (scan::cleanRows), whose table is gone.
OffsetEffect offsetEffect(const scan::SampleRows& rows, const scan::ScanCloud& cloud, double offset);

}  // namespace scan_to_path::sensing
