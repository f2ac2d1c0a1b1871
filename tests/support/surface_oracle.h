// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "scan_to_path/common/random.h"
#include "scan_to_path/geometry/surface.h"

namespace scan_to_path::test {

inline geometry::Vector3 randomVector(Random& random, double half_side) {
  const double x = random.uniform(-half_side, half_side);
  const double y = random.uniform(-half_side, half_side);
  return {x, y, random.uniform(-half_side, half_side)};
}

inline geometry::Vector3 randomDirection(Random& random) {
  const double x = random.gaussian();
  const double y = random.gaussian();
  return geometry::Vector3(x, y, random.gaussian()).normalized();
}

inline geometry::Frame randomFrame(Random& random, double reach = 1.0) {
  const geometry::Vector3 xyz = randomVector(random, reach);
  return geometry::makeFrame(xyz, randomVector(random, 3.0));
}

/// A ray from a point about `centre` at `distance` towards a point within `spread` of the centre.
inline geometry::Ray randomRayTowards(Random& random, const geometry::Vector3& centre, double distance, double spread) {
  const geometry::Vector3 origin = centre + distance * randomDirection(random);
  const geometry::Vector3 target = centre + randomVector(random, spread);
  return {origin, (target - origin).normalized()};
}

/// First sign change of `implicit` along the ray in (0, length], by marching with `step` and bisecting; NaN without.
template <class Implicit>
double marchedHit(const Implicit& implicit, const geometry::Ray& ray, double length, double step) {
  const auto value = [&](double t) { return implicit(geometry::Vector3(ray.origin + t * ray.direction)); };
  double before = value(0.0);
  for (double t = step; t <= length; t += step) {
    const double here = value(t);
    // NaN is outside of an open surface's domain: no crossing there.
    if (std::isfinite(before) && std::isfinite(here) && (before < 0.0) != (here < 0.0)) {
      double low = t - step;
      double high = t;
      for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        ((value(middle) < 0.0) == (before < 0.0) ? low : high) = middle;
      }
      return high;
    }
    before = here;
  }
  return std::nan("");
}

}  // namespace scan_to_path::test
