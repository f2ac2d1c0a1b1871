// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "spikes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace scan_to_path::scan {
namespace {

constexpr std::size_t reach = 5;  // neighbours on each side: an odd number of pairs, two of which may be bad

/// Median of five without branches, so that the loop over samples vectorises.
inline double median5(double a, double b, double c, double d, double e) {
  const double low = std::max(std::min(a, b), std::min(c, d));
  const double high = std::min(std::max(a, b), std::max(c, d));
  return std::max(std::min(low, high), std::min(std::max(low, high), e));
}

/// Height at sample i on the chord from i - k to i + k; samples that do not advance share the chord's middle.
inline double chordHeight(const double* x, const double* z, std::size_t i, std::size_t k) {
  const double share = (x[i] - x[i - k]) / (x[i + k] - x[i - k]);
  const double inside = share >= 0.0 && share <= 1.0 ? share : 0.5;
  return z[i - k] + inside * (z[i + k] - z[i - k]);
}

/// Residual from the extrapolation through the samples k and 2 k away on one side (direction +1 or -1): the median
/// over the k that fit into the row. NaN when none does.
double extrapolationResidual(const RowPiece& piece, std::size_t i, std::ptrdiff_t direction) {
  std::array<double, reach> residuals;
  std::size_t count = 0;
  const auto size = static_cast<std::ptrdiff_t>(piece.size());
  const auto here = static_cast<std::ptrdiff_t>(i);
  for (std::ptrdiff_t k = 1; k <= static_cast<std::ptrdiff_t>(reach); ++k) {
    const std::ptrdiff_t far = here + 2 * k * direction;
    if (far < 0 || far >= size) break;
    const auto b = static_cast<std::size_t>(far);
    const auto a = static_cast<std::size_t>(here + k * direction);
    const double ratio = (piece.x[i] - piece.x[a]) / (piece.x[a] - piece.x[b]);
    const double step = ratio >= 0.0 && ratio <= 3.0 ? ratio : 1.0;
    residuals[count++] = piece.z[i] - piece.z[a] - step * (piece.z[a] - piece.z[b]);
  }
  if (count == 0) return std::nan("");
  std::sort(residuals.begin(), residuals.begin() + static_cast<std::ptrdiff_t>(count));
  return 0.5 * (residuals[(count - 1) / 2] + residuals[count / 2]);
}

}  // namespace

std::vector<double> neighbourResiduals(const RowPiece& piece) {
  const std::size_t n = piece.size();
  std::vector<double> residuals(n, 0.0);
  const double* x = piece.x.data();
  const double* z = piece.z.data();
  for (std::size_t i = reach; i + reach < n; ++i) {
    residuals[i] = z[i] - median5(chordHeight(x, z, i, 1), chordHeight(x, z, i, 2), chordHeight(x, z, i, 3),
                                  chordHeight(x, z, i, 4), chordHeight(x, z, i, 5));
  }
  const auto one_sided = [&](std::size_t i) {
    const double residual = extrapolationResidual(piece, i, 2 * i < n ? 1 : -1);
    residuals[i] = std::isnan(residual) ? 0.0 : residual;
  };
  for (std::size_t i = 0; i < std::min(reach, n); ++i) one_sided(i);
  for (std::size_t i = std::max(n, 2 * reach) - reach; i < n; ++i) one_sided(i);
  return residuals;
}

double medianAbsoluteResidual(const std::vector<PieceResiduals>& residuals) {
  constexpr std::size_t wanted = 50000;
  std::size_t total = 0;
  for (const PieceResiduals& row : residuals) {
    for (const auto& piece : row) total += piece.size();
  }
  const std::size_t stride = total / wanted + 1;
  std::vector<double> sizes;
  for (const PieceResiduals& row : residuals) {
    for (const auto& piece : row) {
      for (std::size_t i = reach; i + reach < piece.size(); i += stride) sizes.push_back(std::abs(piece[i]));
    }
  }
  if (sizes.empty()) return 0.0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

std::vector<char> findSpikes(const RowPiece& piece, const std::vector<double>& residuals, double limit) {
  constexpr double one_sided =
      2.5;  // noise of an extrapolation over that of a chord: sqrt(5 / 0.5) less the median's gain
  const std::size_t n = piece.size();
  std::vector<char> spikes(n, 0);
  const auto beyond = [](double residual, double bound) { return std::isnan(residual) || std::abs(residual) > bound; };
  for (std::size_t i = 0; i < n; ++i) {
    if (std::abs(residuals[i]) <= limit) continue;
    const bool inner = i >= reach && i + reach < n;
    if (!inner && std::abs(residuals[i]) <= one_sided * limit) continue;
    spikes[i] = beyond(extrapolationResidual(piece, i, 1), limit) && beyond(extrapolationResidual(piece, i, -1), limit);
  }
  return spikes;
}

}  // namespace scan_to_path::scan
