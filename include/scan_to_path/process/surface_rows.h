// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/common/progress.h"
#include "scan_to_path/process/cutting_options.h"
#include "scan_to_path/process/row.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/region.h"

namespace scan_to_path::process {

/// Rows as parallel plane sections of the scan's height surface, at options.direction in the scan plane, within the
/// outline less the edge margin. The first and the last row lie on the far edges. Each next row is as far away as the
/// scallop height allows at the tightest place (spec cutting, step 11, planes L cos(slope) apart for a start, then the
/// cusp between the two rows themselves), or one pitch when that is given.
/// They are placed and numbered for the whole part, and then cut where they leave the region [scan frame].
/// Throws InputError when the outline less the margin is empty or no row is in the region, Interrupted.
RowPlan surfaceRows(const scan::FittedScan& scan, const CuttingOptions& options, const Progress& progress = {},
                    const toolpath::Region& region = {});

}  // namespace scan_to_path::process
