// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scan_to_path/common/angles.h"

namespace scan_to_path::scan {
namespace {

constexpr std::size_t least_side = 3;  ///< samples: two have no residual that could tell noise from a bend

/// Least-squares line through a stretch of samples.
struct Direction {
  double variance = 0.0;    ///< of the samples' x, summed [m^2]
  double covariance = 0.0;  ///< of x and height, summed [m^2]

  double angle() const { return std::atan2(covariance, variance); }  ///< [rad]
};

/// Sums from which the least-squares line through any stretch of samples follows.
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

  /// Of samples [begin, end).
  Direction direction(std::size_t begin, std::size_t end) const {
    const double n = static_cast<double>(end - begin);
    const double sx = x[end] - x[begin];
    return {xx[end] - xx[begin] - sx * sx / n, xz[end] - xz[begin] - sx * (z[end] - z[begin]) / n};
  }
};

/// Bends over sample positions that move on along a piece.
class BendFinder {
public:
  BendFinder(const RowPiece& piece, double window) : piece_(piece), sums_(piece), window_(window) {}

  /// Length of the shorter window at sample i [m].
  double shorterWindow(std::size_t i) const {
    return std::min({window_, piece_.x[i] - piece_.x.front(), piece_.x.back() - piece_.x[i]});
  }

  /// Change of direction at sample i between windows of the given length on both sides, cut off at the piece's ends;
  /// 0 where one of them holds too few samples.
  double bend(std::size_t i, double window) const {
    const auto [begin, end] = around(i, window);
    if (i < begin + least_side || end < i + least_side) return 0.0;
    return sums_.direction(i, end).angle() - sums_.direction(begin, i).angle();
  }

  /// Whether the bend at sample i between whole windows is surely below the angle with the given tangent: most samples
  /// are passed over without working out an angle. Samples are to be asked for in rising order.
  bool isBelow(double tangent, std::size_t i) {
    while (piece_.x[begin_] < piece_.x[i] - window_) ++begin_;
    while (end_ < piece_.size() && piece_.x[end_] < piece_.x[i] + window_) ++end_;
    if (i < begin_ + least_side || end_ < i + least_side) return true;
    const Direction before = sums_.direction(begin_, i);
    const Direction after = sums_.direction(i, end_);
    const double sine = before.variance * after.covariance - before.covariance * after.variance;
    const double cosine = before.variance * after.variance + before.covariance * after.covariance;
    return std::abs(sine) < tangent * cosine;
  }

  /// The sample about which the bend is largest, from `from` to the end of one window.
  std::size_t sharpest(std::size_t from) const {
    std::size_t best = from;
    double largest = 0.0;
    for (std::size_t i = from; i < piece_.size() && piece_.x[i] <= piece_.x[from] + window_; ++i) {
      const double angle = std::abs(bend(i, window_));
      if (angle > largest) best = i;
      largest = std::max(largest, angle);
    }
    return best;
  }

  /// The corner about sample i, where the bend is largest. With a window cut short that may be the steepest noise of
  /// few samples instead: there it is where two lines, one on each side, leave the least residual in both windows
  /// together.
  Corner corner(std::size_t i) const {
    Corner best{i, std::abs(bend(i, window_))};
    if (!isCutShort(i)) return best;
    const auto [begin, end] = around(i, window_);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = begin + least_side; k + least_side <= end; ++k) {
      const double residual = offLine(begin, k) + offLine(k, end);
      if (residual < least) best.index = k;
      least = std::min(least, residual);
    }
    best.angle = std::abs(bend(best.index, window_));
    return best;
  }

  /// A corner keeps its angle when the windows get shorter; a round that fills them keeps two thirds of it at most.
  bool isSharp(const Corner& corner) const {
    const std::size_t i = corner.index;
    const auto [begin, end] = around(i, window_);
    const auto [half_begin, half_end] = around(i, 0.5 * window_);
    const std::size_t before = shortened(i - begin, i - half_begin);
    const std::size_t after = shortened(end - i, half_end - i);
    return std::abs(sums_.direction(i, i + after).angle() - sums_.direction(i - before, i).angle()) >
           0.75 * corner.angle;
  }

  /// Whether the bend stands out from the scatter of both directions that the samples' own residuals explain. Whole
  /// windows hold samples enough for any corner_angle.
  bool isAboveNoise(const Corner& corner) const {
    if (!isCutShort(corner.index)) return true;
    constexpr double sigmas = 6.0;  // Student's t of 20 samples: one false corner in a hundred thousand
    const auto [begin, end] = around(corner.index, window_);
    const Direction before = sums_.direction(begin, corner.index);
    const Direction after = sums_.direction(corner.index, end);
    const double freedom = static_cast<double>(end - begin) - 4.0;
    const double noise = (offLine(begin, corner.index) + offLine(corner.index, end)) / freedom;
    // The angle of a line scatters by the noise across it over the samples' spread along it.
    const auto scatter = [noise](const Direction& side) {
      return noise * std::pow(std::cos(side.angle()), 2) / side.variance;
    };
    return corner.angle * corner.angle > sigmas * sigmas * (scatter(before) + scatter(after));
  }

private:
  /// Squares of the distances of samples [begin, end) off their line, summed [m^2].
  double offLine(std::size_t begin, std::size_t end) const {
    const double angle = sums_.direction(begin, end).angle();
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const double across = cosine * (piece_.z[i] - piece_.z[begin]) - sine * (piece_.x[i] - piece_.x[begin]);
      sum += across;
      squares += across * across;
    }
    return squares - sum * sum / static_cast<double>(end - begin);
  }

  bool isCutShort(std::size_t i) const { return shorterWindow(i) < window_; }

  /// Half of the samples on one side; where the piece's end cuts a window short, not so few that noise decides.
  static std::size_t shortened(std::size_t in_window, std::size_t in_half_window) {
    constexpr std::size_t enough = 6;
    return std::min(in_half_window, std::max(in_window / 2, enough));
  }

  std::pair<std::size_t, std::size_t> around(std::size_t i, double window) const {
    return {lowerBound(piece_.x[i] - window), lowerBound(piece_.x[i] + window)};
  }

  std::size_t lowerBound(double x) const {
    return static_cast<std::size_t>(std::lower_bound(piece_.x.begin(), piece_.x.end(), x) - piece_.x.begin());
  }

  const RowPiece& piece_;
  PrefixSums sums_;
  double window_;
  std::size_t begin_ = 0;  ///< of the window before the sample that isBelow() was asked for last
  std::size_t end_ = 0;    ///< of the one after it
};

}  // namespace

std::vector<Corner> findCorners(const RowPiece& piece, const LineFitOptions& options) {
  std::vector<Corner> corners;
  if (piece.size() < 8) return corners;
  const double spacing = (piece.x.back() - piece.x.front()) / static_cast<double>(piece.size() - 1);
  const double window = std::max(options.corner_window, 8.0 * spacing);
  BendFinder finder(piece, window);
  const double half = 0.5 * options.corner_angle;
  const double tangent = half < right_angle ? std::tan(half) : 0.0;
  double next = piece.x.front();
  for (std::size_t i = 1; i < piece.size(); ++i) {
    if (piece.x[i] < next) continue;
    // Half way into a window a corner still shows three quarters of its angle.
    next = piece.x[i] + 0.25 * finder.shorterWindow(i);
    if (finder.isBelow(tangent, i) || std::abs(finder.bend(i, window)) < half) continue;
    const Corner corner = finder.corner(finder.sharpest(i));
    if (corner.angle < options.corner_angle || !finder.isSharp(corner) || !finder.isAboveNoise(corner)) continue;
    if (!corners.empty() && corner.index <= corners.back().index) continue;
    corners.push_back(corner);
    next = piece.x[corner.index] + window;
  }
  return corners;
}

}  // namespace scan_to_path::scan
