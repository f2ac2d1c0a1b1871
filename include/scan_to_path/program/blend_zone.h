// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::program {

/// Largest radius [m] of a blend at `at` that stays within `tolerance` [m] of the lines before-at-after and of `at`.
///
/// A controller blends inside the triangle of the corner and the two points at distance r from it. With turning angle
/// a, every point of that triangle is within r sin(a/2) cos(a/2) of the lines, and the blend passes the corner at
/// r sin(a/2) at most: r = tolerance / sin(a/2), whatever curve the controller uses. At most half the way to either
/// neighbour, where the next blend begins. 0 where a neighbour coincides.
double blendRadius(const geometry::Vector3& before, const geometry::Vector3& at, const geometry::Vector3& after,
                   double tolerance);

}  // namespace scan_to_path::program
