// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/scan/sample_log.h"
#include "scan_to_path/sensing/point_laser.h"
#include "scan_to_path/sensing/row_motion.h"

namespace scan_to_path::sensing {

/// Rows that are compared with one another: a third difference across.
constexpr std::size_t rows_compared = 4;

/// A place where four neighbouring rows, scanned to and fro in turn, are compared. With samples placed by a clock that
/// is off by dt, every row's height is off by its velocity times slope times dt, so that
/// difference = gain * dt + the third difference of the part's own shape + noise.
struct RowComparison {
  double difference = 0.0;  ///< third divided difference of the height, weights' sizes adding up to 1 [m]
  double gain = 0.0;        ///< the same of velocity times slope [m/s]
  std::size_t group = 0;    ///< first of the four rows
};

/// Where and how rows are compared.
struct ComparisonSettings {
  double cell = 0.002;      ///< spacing of the places along the rows [m]
  double min_slope = 0.01;  ///< weighted mean of the rows' slopes from which a place tells something
};

/// First rows of all groups of four neighbouring rows, to and fro in turn, one beside the other; at most about
/// `max_rows` rows, in blocks spread over the scan.
std::vector<std::size_t> chooseGroups(const std::vector<MotionRow>& rows, int max_rows);

/// Compares the rows of all groups, samples placed at `clock_offset` [s]. Straight lines are fitted to the samples
/// around every place; places with a spike, a jump or an edge, and those without slope, are left out.
std::vector<RowComparison> compareRows(const scan::SampleLog& log, const PointLaserOptions& laser,
                                       const SensorMotion& motion, const RowMotion& rows,
                                       const std::vector<std::size_t>& groups, const ComparisonSettings& settings,
                                       double clock_offset);

}  // namespace scan_to_path::sensing
