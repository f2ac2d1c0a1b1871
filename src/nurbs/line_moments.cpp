// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/line_moments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cubic.h"
#include "cubic_moments.h"
#include "fit_criterion.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "sorted_samples.h"
#include "span_layout.h"
#include "spline_equations.h"

namespace scan_to_path::nurbs {
namespace {

constexpr std::size_t samples_per_cell = 12;  // at least, and below twice as many: cells are a power of two
constexpr std::size_t min_cells = 64;
constexpr int max_blocks = 8;  // in a span

/// A part of a span: 1 or 2 blocks from place `index` on, in a span of `blocks` blocks.
const LocalMap& partMap(int blocks, int index, int size) {
  static const std::vector<LocalMap> maps = [] {
    std::vector<LocalMap> table;
    for (int m = 1; m <= max_blocks; ++m) {
      for (int b = 0; b < 2 * max_blocks; ++b) {
        const double width = b % 2 + 1.0;
        table.emplace_back(width / m, (2.0 * (b / 2) + width - m) / m);
      }
    }
    return table;
  }();
  return maps[static_cast<std::size_t>(((blocks - 1) * max_blocks + index) * 2 + size - 1)];
}

}  // namespace

struct LineMoments::Data {
  /// Cells merged pairwise, level by level; level 0 is the finest.
  struct Level {
    std::vector<CubicMoments> blocks;
    double rss = 0.0;  // of the best piecewise cubic, one polynomial per block
    int rank = 0;      // coefficients that it has

    void sumUp() {
      Lanes rest;
      for (const CubicMoments& block : blocks) {
        const CubicResidual residual(block);
        rest += residual.rest;
        rank += residual.rank();
      }
      rss = sumOfCoordinates(rest);
    }
  };
  struct Solution {
    SplineEquations equations;
    std::vector<double> knots;
  };

  std::size_t count = 0;
  double first = 0.0;
  double last = 0.0;
  double largest_gap = 0.0;
  Lanes origin;
  std::vector<Level> levels;

  explicit Data(const LineSamples& line) {
    const SortedSamples sorted(line);
    const LineSamples& samples = sorted.view();
    count = samples.count;
    first = samples.u[0];
    last = samples.u[count - 1];
    largest_gap = sorted.largestGap();
    origin = Lanes(samples.x[0], samples.y[0], samples.z[0], 0.0);
    if (!(first < last)) throw InputError("curve fit", "parameter range", std::to_string(last - first), "above 0");
    fillFinest(samples);
    while (levels.back().blocks.size() > 1) levels.push_back(merged(levels.back()));
    for (Level& level : levels) level.sumUp();
    if (!std::isfinite(sumOfCoordinates(levels.back().blocks[0].squares))) SortedSamples::checkFinite(line);
  }

  void fillFinest(const LineSamples& samples) {
    const std::size_t cells = powerOfTwoAtMost(std::max(min_cells, count / samples_per_cell));
    const double width = (last - first) / static_cast<double>(cells);
    levels.emplace_back();
    levels[0].blocks.reserve(cells);
    std::size_t begin = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      const double end_of_cell = first + width * static_cast<double>(c + 1);
      std::size_t end = c + 1 == cells ? count : begin;
      while (end < count && samples.u[end] < end_of_cell) ++end;
      const double centre = first + width * (static_cast<double>(c) + 0.5);
      levels[0].blocks.push_back(accumulate(samples, begin, end, centre, 2.0 / width));
      begin = end;
    }
  }

  static Level merged(const Level& fine) {
    Level coarse;
    coarse.blocks.reserve(fine.blocks.size() / 2);
    const int blocks = static_cast<int>(fine.blocks.size());
    for (int i = 0; i < blocks; i += 2) coarse.blocks.push_back(joined(fine, nullptr, i, i + 2));
    return coarse;
  }

  /// Moments of blocks begin … end of a level, two at a time where the next coarser level has them merged.
  static CubicMoments joined(const Level& level, const Level* coarser, int begin, int end) {
    CubicMoments whole;
    int size = 1;
    for (int b = begin; b < end; b += size) {
      const bool pair = coarser != nullptr && b % 2 == 0 && b + 2 <= end;
      const auto place = static_cast<std::size_t>(b);
      const CubicMoments& part = pair ? coarser->blocks[place / 2] : level.blocks[place];
      size = pair ? 2 : 1;
      if (part.count() == 0.0) continue;
      if (whole.count() == 0.0) whole.reference = part.reference;
      addMapped(whole, part, partMap(end - begin, b - begin, size));
    }
    return whole;
  }

  /// The coarsest level with at least four blocks per span, else the finest.
  std::size_t levelFor(std::size_t spans) const {
    std::size_t l = levels.size() - 1;
    while (l > 0 && levels[l].blocks.size() < 4 * spans) --l;
    return l;
  }

  bool allows(int control_points) const {
    if (control_points <= degree || 2 * static_cast<std::size_t>(control_points) > count) return false;
    return static_cast<std::size_t>(control_points - degree) <= levels[0].blocks.size();
  }

  std::optional<Solution> solve(int control_points) const {
    if (!allows(control_points)) return std::nullopt;
    const int spans = control_points - degree;
    const std::size_t l = levelFor(static_cast<std::size_t>(spans));
    const Level* coarser = l + 1 < levels.size() ? &levels[l + 1] : nullptr;
    const int blocks = static_cast<int>(levels[l].blocks.size());
    const std::vector<int> ends = spanEnds(spans, blocks);
    Solution solution{SplineEquations(static_cast<std::size_t>(control_points), origin),
                      cubicKnots(ends, blocks, first, last)};
    for (int i = 0; i < spans; ++i) {
      const auto place = static_cast<std::size_t>(i);
      const CubicMoments span = joined(levels[l], coarser, ends[place], ends[place + 1]);
      if (span.count() == 0.0) return std::nullopt;
      solution.equations.add(place, span, spanMatrix(ends, i));
    }
    if (!solution.equations.solve()) return std::nullopt;
    return solution;
  }
};

LineMoments::LineMoments(const LineSamples& samples) : data_(std::make_shared<const Data>(samples)) {}

std::size_t LineMoments::samples() const { return data_->count; }
double LineMoments::first() const { return data_->first; }
double LineMoments::last() const { return data_->last; }
double LineMoments::largestGap() const { return data_->largest_gap; }

int LineMoments::usefulControlPoints(double noise) const {
  const double n = static_cast<double>(data_->count);
  double best = std::numeric_limits<double>::infinity();
  std::size_t best_blocks = 1;
  for (const Data::Level& level : data_->levels) {
    if (2.0 * level.rank > n) continue;
    const double score = criterion(n, level.rss, level.rank, noise);
    if (score < best) {
      best = score;
      best_blocks = level.blocks.size();
    }
  }
  // A smooth curve's best spline has about 1.6 times as many spans as its best piecewise cubic (from the two error
  // constants and 1 against 4 parameters per span), and halving finds the latter to within a factor of 1.4: 2.3.
  const std::size_t spans = std::min(3 * best_blocks, data_->levels[0].blocks.size());
  return static_cast<int>(spans) + degree;
}

double LineMoments::rss(int control_points) const {
  const auto solution = data_->solve(control_points);
  return solution ? solution->equations.rss() : std::numeric_limits<double>::quiet_NaN();
}

CurveFit LineMoments::fit(int control_points) const {
  CurveFit result;
  result.samples = data_->count;
  result.largest_gap = data_->largest_gap;
  const auto solution = data_->solve(control_points);
  if (!solution) return result;
  const double n = static_cast<double>(data_->count);
  const double sum = solution->equations.rss();
  result.fitted = true;
  result.curve.knots = solution->knots;
  result.curve.control_points = solution->equations.controlPoints();
  result.rms = std::sqrt(sum / n);
  result.sigma = std::sqrt(sum / (n - control_points));
  return result;
}

}  // namespace scan_to_path::nurbs
