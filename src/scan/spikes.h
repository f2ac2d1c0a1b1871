// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::scan {

/// The residuals of one row's pieces.
using PieceResiduals = std::vector<std::vector<double>>;

/// Residual of every height from what its neighbours along the row say [m]: blind to slope. Samples closer than
/// five to an end have the residual of one-sided extrapolation, whose noise is about three times as large.
std::vector<double> neighbourResiduals(const RowPiece& piece);

/// Median of |residual| over (a subsample of) all rows' inner samples [m].
double medianAbsoluteResidual(const std::vector<PieceResiduals>& residuals);

/// Marks the samples whose residual is over `limit` and that no one-sided extrapolation confirms either.
std::vector<char> findSpikes(const RowPiece& piece, const std::vector<double>& residuals, double limit);

}  // namespace scan_to_path::scan
