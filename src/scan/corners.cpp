// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "scan_to_path/scan/line_fit.h"

namespace scan_to_path::scan {
namespace {

/// Sums from which the slope of any stretch of samples follows.
struct PrefixSums {
  std::vector<double> x, z, xx, xz;

  explicit PrefixSums(const RowPiece& piece) {
    for (auto* sums : {&x, &z, &xx, &xz}) sums->assign(piece.size() + 1, 0.0);
    const double x0 = piece.x.front();
    const double z0 = piece.z.front();
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const double dx = piece.x[i] - x0;
      const double dz = piece.z[i] - z0;
      x[i + 1] = x[i] + dx;
      z[i + 1] = z[i] + dz;
      xx[i + 1] = xx[i] + dx * dx;
      xz[i + 1] = xz[i] + dx * dz;
    }
  }

  /// Direction angle of the least-squares line through samples [begin, end).
  double direction(std::size_t begin, std::size_t end) const {
    const double n = static_cast<double>(end - begin);
    const double sx = x[end] - x[begin];
    const double variance = xx[end] - xx[begin] - sx * sx / n;
    const double covariance = xz[end] - xz[begin] - sx * (z[end] - z[begin]) / n;
    return std::atan2(covariance, variance);
  }
};

/// Bends over sample positions that move on along a piece.
class BendFinder {
public:
  BendFinder(const RowPiece& piece, double window) : piece_(piece), sums_(piece), window_(window) {}

  /// Change of direction at sample i between windows of the given length on both sides; 0 where they do not fit in.
  double bend(std::size_t i, double window) const {
    if (piece_.x[i] - window < piece_.x.front() || piece_.x[i] + window > piece_.x.back()) return 0.0;
    const auto begin = lowerBound(piece_.x[i] - window);
    const auto end = lowerBound(piece_.x[i] + window);
    constexpr std::size_t least = 3;
    if (i < begin + least || end < i + least) return 0.0;
    return sums_.direction(i, end) - sums_.direction(begin, i);
  }

  /// A corner keeps its angle over half of the window; a round keeps half of it.
  bool isSharp(std::size_t i, double angle) const { return std::abs(bend(i, 0.5 * window_)) > 0.75 * angle; }

private:
  std::size_t lowerBound(double x) const {
    return static_cast<std::size_t>(std::lower_bound(piece_.x.begin(), piece_.x.end(), x) - piece_.x.begin());
  }

  const RowPiece& piece_;
  PrefixSums sums_;
  double window_;
};

/// The sample about which the bend is largest, from `from` to the end of one window.
Corner sharpest(const BendFinder& finder, const RowPiece& piece, std::size_t from, double window) {
  Corner corner;
  const double until = piece.x[from] + window;
  for (std::size_t i = from; i < piece.size() && piece.x[i] <= until; ++i) {
    const double angle = std::abs(finder.bend(i, window));
    if (angle > corner.angle) corner = {i, angle};
  }
  return corner;
}

}  // namespace

std::vector<Corner> findCorners(const RowPiece& piece, const LineFitOptions& options) {
  std::vector<Corner> corners;
  if (piece.size() < 8) return corners;
  const double spacing = (piece.x.back() - piece.x.front()) / static_cast<double>(piece.size() - 1);
  const double window = std::max(options.corner_window, 8.0 * spacing);
  const BendFinder finder(piece, window);
  double next = piece.x.front();
  for (std::size_t i = 1; i < piece.size(); ++i) {
    if (piece.x[i] < next) continue;
    next = piece.x[i] + 0.25 * window;  // half way into a window a corner still shows three quarters of its angle
    if (std::abs(finder.bend(i, window)) < 0.5 * options.corner_angle) continue;
    const Corner corner = sharpest(finder, piece, i, window);
    if (corner.angle < options.corner_angle || !finder.isSharp(corner.index, corner.angle)) continue;
    corners.push_back(corner);
    next = piece.x[corner.index] + window;
  }
  return corners;
}

}  // namespace scan_to_path::scan
