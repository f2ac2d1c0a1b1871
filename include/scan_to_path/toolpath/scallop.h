// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace scan_to_path::toolpath {

/// Distance along the surface between two rows of a ball of radius r that leave the scallop height h, exactly, on a
/// surface of curvature kappa = 1/rho across the rows (convex > 0). Spec cutting, step 11:
///   cos(phi/2) = ((rho + r)^2 + (rho + h)^2 - r^2) / (2 (rho + r)(rho + h)),  L = rho phi;
/// the plane's L = 2 sqrt(2 r h - h^2) is its limit. Computed from the half-angle form, which does not cancel.
/// All in [m] and [1/m]. Throws InputError unless 0 < h < r, kappa > -1/r (else the ball gouges), and the ball can
/// leave so high a scallop at all (h at most largestScallop).
double rowDistance(double scallop_height, double ball_radius, double curvature);

/// The inverse: scallop height left between two rows at distance L along the surface. 0 for L = 0.
/// Throws InputError for r <= 0, L < 0, kappa <= -1/r and for rows so far apart that the balls do not meet.
double scallopHeight(double row_distance, double ball_radius, double curvature);

/// The highest scallop two rows of this ball can leave between them [m]: the cusp where the balls part,
/// (sqrt(1 + 2 kappa r) - 1) / kappa, r on a plane; twice the gap between ball and hollow, 2 (1/|kappa| - r), where
/// the ball is larger than half of the hollow's radius. rowDistance() takes heights up to that and below r.
/// Throws InputError for r <= 0 and kappa <= -1/r.
double largestScallop(double ball_radius, double curvature);

}  // namespace scan_to_path::toolpath
