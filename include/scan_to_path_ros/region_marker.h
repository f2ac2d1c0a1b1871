// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path_ros {

/// path.region as a closed line over the scanned part, at its highest, in the frame of `header`, which the scan and
/// the work object are given in; what takes an earlier one away when there is no region.
visualization_msgs::Marker regionMarker(const scan_to_path::pipeline::JobOptions& options,
                                        const scan_to_path::scan::FittedScan& scan, const std_msgs::Header& header);

}  // namespace scan_to_path_ros
