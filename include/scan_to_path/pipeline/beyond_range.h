// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "scan_to_path/scan/no_returns.h"
#include "scan_to_path/scan/sample_rows.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path::pipeline {

/// Lengths of rows on which nothing came back because the part lies nearer or farther than the sensor sees [m].
struct BeyondRange {
  double too_near = 0.0;
  double too_far = 0.0;
};

/// The same split into where `is_inside(x, y)` holds in the scan frame and where it does not.
struct BeyondRangeLengths {
  BeyondRange inside;
  BeyondRange outside;
};

/// Tells a part that is cut off by the range from one that ends: all samples are sorted into patches one row wide and
/// about ten samples long in the scan frame. Patches without a return belong to the part where
/// - their voltage says too near and they touch the part, directly or over other such patches, or
/// - the part's height, extrapolated linearly over its two nearest patches, has left the range there, and, in the same
///   direction, as far as nothing comes back.
/// An edge within the range, of a hole or of the part, is neither. `rows` are those of cleanRows of `cloud`, the
/// samples of the cloud that are not in them count as something else that was seen. `row_distance` [m] > 0.
BeyondRangeLengths lengthsBeyondRange(const scan::ScanCloud& cloud, const scan::SampleRows& rows,
                                      const scan::NoReturns& no_returns, double row_distance,
                                      const std::function<bool(double x, double y)>& is_inside);

}  // namespace scan_to_path::pipeline
