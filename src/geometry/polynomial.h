// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace scan_to_path::geometry {

/// Coefficients from the constant term upwards.
using Polynomial = std::vector<double>;

/// Real roots in [low, high], rising. The roots of the derivative part the interval into monotone pieces, each with
/// at most one root, found by Newton's method kept inside its bracket; a double root may be found once, twice or not.
std::vector<double> realRoots(const Polynomial& p, double low, double high);

}  // namespace scan_to_path::geometry
