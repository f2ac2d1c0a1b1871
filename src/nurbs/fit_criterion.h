// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace scan_to_path::nurbs {

/// Generalised cross-validation (Craven & Wahba 1979) or, with known noise, Mallows' Cp, per sample.
inline double criterion(double n, double rss, double parameters, double noise) {
  if (noise > 0.0) return (rss + 2.0 * noise * noise * parameters) / n;
  return n * rss / ((n - parameters) * (n - parameters));
}

}  // namespace scan_to_path::nurbs
