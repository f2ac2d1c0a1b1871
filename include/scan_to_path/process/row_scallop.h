// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scan_to_path/process/row.h"
#include "scan_to_path/toolpath/scan_surface.h"

namespace scan_to_path::process {

/// Height over the surface of the cusp that a ball leaves between two neighbouring rows, at its highest: the cusp is r
/// from both rows' lines of ball centres (straight between waypoints), found at `a`'s waypoints and between them.
/// Places where the ball gouges are left out. Nothing where the rows do not run side by side; infinite where the balls
/// do not meet. O(points).
std::optional<double> widestScallop(const Row& a, const Row& b, const toolpath::ScanSurface& surface,
                                    double ball_radius);

/// The same for all pieces of two neighbouring rows.
std::optional<double> widestScallop(const std::vector<Row>& a, const std::vector<Row>& b,
                                    const toolpath::ScanSurface& surface, double ball_radius);

/// The same between pieces that were cut out of rows `whole_a` and `whole_b` and given waypoints of their own, judged
/// at the waypoints of the whole rows where the pieces run side by side, and at those next to it. What whole rows keep,
/// any pieces of them keep then; the moves of both lie within the same chord tolerance of the rows.
std::optional<double> widestScallopOfCut(const std::vector<Row>& a, const std::vector<Row>& b,
                                         const std::vector<Row>& whole_a, const std::vector<Row>& whole_b,
                                         const toolpath::ScanSurface& surface, double ball_radius);

/// Throws InputError when a scallop is infinite: rows so far apart leave a strip uncut. `row` is the second one's.
void checkThatBallsMeet(double scallop, int row, double ball_radius);

}  // namespace scan_to_path::process
