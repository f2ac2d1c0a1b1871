// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/process/cutting_options.h"
#include "scan_to_path/process/row.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/region.h"

namespace scan_to_path::process {

/// Rows on the scan's own fitted lines, the seed's way: one piece per line, less the edge margin at ends that are the
/// part's edge. A line is cut where it leaves the region [scan frame]. Row distances are those of the lines; the
/// scallop is what they leave between them. Throws InputError when no line is long enough or in the region.
RowPlan scanLineRows(const scan::FittedScan& scan, const CuttingOptions& options, const toolpath::Region& region = {});

}  // namespace scan_to_path::process
