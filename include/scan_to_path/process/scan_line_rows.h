// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/process/cutting_options.h"
#include "scan_to_path/process/row.h"
#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::process {

/// Rows on the scan's own fitted lines, the seed's way: one piece per line, less the edge margin at ends that are the
/// part's edge. Row distances are those of the lines; the scallop is what they leave between them.
/// Throws InputError when no line is long enough.
RowPlan scanLineRows(const scan::FittedScan& scan, const CuttingOptions& options);

}  // namespace scan_to_path::process
