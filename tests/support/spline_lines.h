// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/common/random.h"
#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/nurbs/curve_fit.h"
#include "scan_to_path/nurbs/surface_fit.h"

namespace scan_to_path::test {

/// Samples of a line in arrays of their own.
struct SampledLine {
  std::vector<double> u;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;

  void add(double parameter, double px, double py, double pz) {
    u.push_back(parameter);
    x.push_back(px);
    y.push_back(py);
    z.push_back(pz);
  }
  nurbs::LineSamples view() const { return {u.data(), x.data(), y.data(), z.data(), u.size()}; }
  nurbs::HeightSamples heights() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

/// A line along x over the S part, error set "white": noise in z only. u is x.
inline SampledLine sPartLine(double y, std::size_t samples, double sigma, Random& random) {
  const geometry::SPart part;
  SampledLine line;
  for (std::size_t i = 0; i < samples; ++i) {
    const double x = 0.24 * static_cast<double>(i) / static_cast<double>(samples - 1);
    line.add(x, x, y, part.jet(x, y).z + sigma * random.gaussian());
  }
  return line;
}

/// Lines over the S part at the given y [m].
inline std::vector<SampledLine> sPartLines(std::size_t samples, double sigma, std::uint64_t seed,
                                           const std::vector<double>& rows) {
  Random random(seed);
  std::vector<SampledLine> lines;
  for (const double y : rows) lines.push_back(sPartLine(y, samples, sigma, random));
  return lines;
}

inline std::vector<double> sPartRows() {
  std::vector<double> rows;
  for (int i = 0; i <= 40; ++i) rows.push_back(0.004 * i);
  return rows;
}

}  // namespace scan_to_path::test
