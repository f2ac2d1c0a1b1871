// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/line_moments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cubic_moments.h"
#include "fit_criterion.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "sorted_samples.h"
#include "spline_equations.h"

namespace scan_to_path::nurbs {
namespace {

constexpr int degree = 3;
constexpr std::size_t samples_per_cell = 12;  // at least, and below twice as many: cells are a power of two
constexpr std::size_t min_cells = 64;

/// Clamped knot at position i in a list of span ends: i = 0 is the first end, lower and higher ones repeat the ends.
double clampedKnot(const std::vector<int>& ends, int i) {
  return ends[static_cast<std::size_t>(std::clamp(i, 0, static_cast<int>(ends.size()) - 1))];
}

CubicSpanMatrix spanMatrix(const std::vector<int>& ends, int span) {
  double knots[6];
  for (int j = 0; j < 6; ++j) knots[j] = clampedKnot(ends, span - 2 + j);
  return cubicSpanMatrix(knots);
}

/// Polynomial of a block of the span in the block's own parameter.
void blockPolynomial(const LocalMap& map, const Lanes a[4], Lanes block[4]) {
  const auto& c = map.c;
  block[0] = a[0] + c[1][0] * a[1] + c[2][0] * a[2] + c[3][0] * a[3];
  block[1] = c[1][1] * a[1] + c[2][1] * a[2] + c[3][1] * a[3];
  block[2] = c[2][2] * a[2] + c[3][2] * a[3];
  block[3] = c[3][3] * a[3];
}

std::size_t powerOfTwoAtMost(std::size_t n) {
  std::size_t power = 1;
  while (2 * power <= n) power *= 2;
  return power;
}

}  // namespace

/// Cells merged pairwise, level by level; level 0 is the finest.
struct LineMoments::Data {
  struct Level {
    std::vector<CubicMoments> blocks;
    std::vector<CubicResidual> residuals;

    void factor() {
      residuals.reserve(blocks.size());
      for (const CubicMoments& block : blocks) residuals.emplace_back(block);
    }
  };
  /// A solved spline: ends of its spans, in blocks of the level.
  struct Solution {
    const Level* level;
    std::vector<int> ends;
    std::vector<double> rows;  // control points less the origin, 1
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
    if (!(first < last)) {
      throw InputError("curve fit", "parameter range", std::to_string(last - first), "above 0");
    }
    fillFinest(samples);
    while (levels.back().blocks.size() > 1) levels.push_back(merged(levels.back()));
    if (!std::isfinite(sumOfCoordinates(levels.back().blocks[0].squares))) SortedSamples::checkFinite(line);
    for (Level& level : levels) level.factor();
  }

  void fillFinest(const LineSamples& samples) {
    const std::size_t cells = std::max(min_cells, powerOfTwoAtMost(count / samples_per_cell));
    const double width = (last - first) / static_cast<double>(cells);
    const double inverse_half = 2.0 / width;
    levels.emplace_back();
    levels[0].blocks.reserve(cells);
    std::size_t begin = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      const double end_of_cell = first + width * static_cast<double>(c + 1);
      std::size_t end = c + 1 == cells ? count : begin;
      while (end < count && samples.u[end] < end_of_cell) ++end;
      const double centre = first + width * (static_cast<double>(c) + 0.5);
      levels[0].blocks.push_back(accumulate(samples, begin, end, centre, inverse_half));
      begin = end;
    }
  }

  static Level merged(const Level& fine) {
    Level coarse;
    coarse.blocks.resize(fine.blocks.size() / 2);
    for (std::size_t i = 0; i < coarse.blocks.size(); ++i) {
      const CubicMoments& left = fine.blocks[2 * i];
      const CubicMoments& right = fine.blocks[2 * i + 1];
      CubicMoments& whole = coarse.blocks[i];
      whole.reference = left.count() > 0.0 ? left.reference : right.reference;
      addMapped(whole, left, blockMap(2, 0));
      addMapped(whole, right, blockMap(2, 1));
    }
    return coarse;
  }

  /// The coarsest level with at least four blocks per span, else the finest.
  const Level& levelFor(std::size_t spans) const {
    std::size_t l = levels.size() - 1;
    while (l > 0 && levels[l].blocks.size() < 4 * spans) --l;
    return levels[l];
  }

  bool allows(int control_points) const {
    if (control_points <= degree || 2 * static_cast<std::size_t>(control_points) > count) return false;
    return static_cast<std::size_t>(control_points - degree) <= levels[0].blocks.size();
  }

  /// Ends of nearly uniform spans on the block grid, the same from either end of the line.
  static std::vector<int> spanEnds(int spans, int blocks) {
    std::vector<int> ends(static_cast<std::size_t>(spans) + 1);
    for (int k = 0; 2 * k <= spans; ++k) {
      const int end = static_cast<int>((2LL * k * blocks + spans) / (2LL * spans));
      ends[static_cast<std::size_t>(k)] = end;
      ends[static_cast<std::size_t>(spans - k)] = blocks - end;
    }
    return ends;
  }

  std::optional<Solution> solve(int control_points) const {
    if (!allows(control_points)) return std::nullopt;
    const int spans = control_points - degree;
    const Level& level = levelFor(static_cast<std::size_t>(spans));
    Solution solution{&level, spanEnds(spans, static_cast<int>(level.blocks.size())), {}};
    NormalEquations equations(static_cast<std::size_t>(control_points));
    for (int i = 0; i < spans; ++i) {
      const int begin = solution.ends[static_cast<std::size_t>(i)];
      const int blocks = solution.ends[static_cast<std::size_t>(i) + 1] - begin;
      CubicMoments span;
      span.reference = origin;
      for (int b = 0; b < blocks; ++b) {
        addMapped(span, level.blocks[static_cast<std::size_t>(begin + b)], blockMap(blocks, b));
      }
      if (span.count() == 0.0) return std::nullopt;
      equations.add(static_cast<std::size_t>(i), span, spanMatrix(solution.ends, i));
    }
    if (!equations.solve()) return std::nullopt;
    solution.rows = std::move(equations.rhs);
    return solution;
  }

  double rss(const Solution& solution) const {
    Lanes sum;
    for (int i = 0; i + 1 < static_cast<int>(solution.ends.size()); ++i) {
      const int begin = solution.ends[static_cast<std::size_t>(i)];
      const int blocks = solution.ends[static_cast<std::size_t>(i) + 1] - begin;
      Lanes span[4];
      spanPolynomial(spanMatrix(solution.ends, i), &solution.rows[4 * static_cast<std::size_t>(i)], span);
      for (int b = 0; b < blocks; ++b) {
        Lanes block[4];
        blockPolynomial(blockMap(blocks, b), span, block);
        sum += solution.level->residuals[static_cast<std::size_t>(begin + b)].of(block, origin);
      }
    }
    return sumOfCoordinates(sum);
  }

  std::vector<double> knots(const Solution& solution) const {
    const double blocks = static_cast<double>(solution.level->blocks.size());
    std::vector<double> result(degree, first);
    for (const int end : solution.ends) result.push_back(first + (last - first) * end / blocks);
    result.back() = last;
    result.insert(result.end(), degree, last);
    return result;
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
    Lanes rest;
    int rank = 0;
    for (const CubicResidual& residual : level.residuals) {
      rest += residual.rest;
      rank += residual.rank();
    }
    if (2.0 * rank > n) continue;
    const double score = criterion(n, sumOfCoordinates(rest), rank, noise);
    if (score < best) {
      best = score;
      best_blocks = level.blocks.size();
    }
  }
  // A smooth curve's best spline has about 1.6 times as many spans as its best piecewise cubic (from the two error
  // constants and 1 against 4 parameters per span); halving finds the latter to within a factor of 1.4.
  const std::size_t spans = std::min(4 * best_blocks, data_->levels[0].blocks.size());
  return static_cast<int>(spans) + degree;
}

double LineMoments::rss(int control_points) const {
  const auto solution = data_->solve(control_points);
  return solution ? data_->rss(*solution) : std::numeric_limits<double>::quiet_NaN();
}

CurveFit LineMoments::fit(int control_points) const {
  CurveFit result;
  result.samples = data_->count;
  result.largest_gap = data_->largest_gap;
  const auto solution = data_->solve(control_points);
  if (!solution) return result;
  const double n = static_cast<double>(data_->count);
  const double sum = data_->rss(*solution);
  result.fitted = true;
  result.curve.knots = data_->knots(*solution);
  result.curve.control_points = controlPoints(solution->rows, data_->origin);
  result.rms = std::sqrt(sum / n);
  result.sigma = std::sqrt(sum / (n - control_points));
  return result;
}

}  // namespace scan_to_path::nurbs
