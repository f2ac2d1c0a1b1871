// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/blend_zone.h"

#include <algorithm>
#include <cmath>

namespace scan_to_path::program {

double blendRadius(const geometry::Vector3& before, const geometry::Vector3& at, const geometry::Vector3& after,
                   double tolerance) {
  const double length_in = (at - before).norm();
  const double length_out = (after - at).norm();
  const double half_way = 0.5 * std::min(length_in, length_out);
  if (half_way <= 0.0) return 0.0;
  // For unit vectors u, v at an angle a, |u - v| = 2 sin(a/2).
  const double sine_half = 0.5 * ((at - before) / length_in - (after - at) / length_out).norm();
  return sine_half * half_way <= tolerance ? half_way : tolerance / sine_half;
}

}  // namespace scan_to_path::program
