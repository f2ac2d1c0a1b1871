// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "scan_to_path/common/error.h"
#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::nurbs {

/// Throws InputError unless points are finite and weights, if any, positive, finite and one per control point.
inline void validateControlPoints(const std::vector<geometry::Vector3>& points, const std::vector<double>& weights,
                                  const std::string& where) {
  if (!weights.empty() && weights.size() != points.size()) {
    throw InputError(where, "number of weights", std::to_string(weights.size()),
                     "0 or " + std::to_string(points.size()));
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] > 0.0) || !std::isfinite(weights[i])) {
      throw InputError(where, "weight " + std::to_string(i), std::to_string(weights[i]), "positive and finite");
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      throw InputError(where, "control point " + std::to_string(i), "not finite", "finite");
    }
  }
}

}  // namespace scan_to_path::nurbs
