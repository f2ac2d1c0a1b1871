// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "runs.h"

namespace scan_to_path::scan {

/// Median distance across of runs that lie beside each other by more than `margin` [m]. Precondition: sorted by y.
/// Throws InputError when there are none.
double medianPitch(const std::vector<Run>& runs, double margin);

/// Numbers the rows across from 0 and returns how many there are. Runs at one y that do not overlap share a row.
/// Precondition: sorted by y.
int numberRows(std::vector<Run>& runs, double pitch, double margin);

/// Throws InputError when the order of two rows changes along them: they cross each other. Precondition: sorted by row.
void checkOrder(const Track& track, const std::vector<Run>& runs, double margin);

}  // namespace scan_to_path::scan
