// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/control_point_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cubic.h"
#include "fit_criterion.h"
#include "scan_to_path/common/parallel.h"

namespace scan_to_path::nurbs {
namespace {

/// Numbers of control points to try, rising.
std::vector<int> candidateCounts(int largest) {
  std::vector<int> counts;
  for (int p = degree + 1; p <= largest; p = std::max(p + 1, p * 23 / 20)) counts.push_back(p);
  return counts;
}

double length(const LineMoments& line) { return line.last() - line.first(); }

/// Calls visit(j) for the lines that choose together with line i: it and its neighbours, but for stubs, which would
/// ask for knot spacings far from those of a long line.
template <class Visitor>
void forPool(const std::vector<LineMoments>& lines, std::size_t i, std::size_t window, Visitor&& visit) {
  for (std::size_t j = i - std::min(i, window); j < std::min(lines.size(), i + window + 1); ++j) {
    const double ratio = length(lines[j]) / length(lines[i]);
    if (ratio > 0.5 && ratio < 2.0) visit(j);
  }
}

/// Residual sums of all lines for the candidates that may be asked for.
class ResidualTable {
public:
  ResidualTable(const std::vector<LineMoments>& lines, const CurveFitOptions& options, int threads)
      : lines_(lines), counts_(candidateCounts(options.max_control_points)), sums_(lines.size()) {
    const auto window = static_cast<std::size_t>(options.window);
    std::vector<double> useful(lines.size());  // spans per unit of the parameter
    for (std::size_t i = 0; i < lines.size(); ++i) {
      useful[i] = (lines[i].usefulControlPoints(options.noise) - degree) / length(lines[i]);
    }
    std::vector<std::size_t> needed(lines.size(), 0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      double density = 0.0;
      forPool(lines, i, window, [&](std::size_t j) { density = std::max(density, useful[j]); });
      tried_.push_back(candidatesUpTo(i, density));
      forPool(lines, i, window,
              [&](std::size_t j) { needed[j] = std::max(needed[j], matching(i, tried_[i] - 1, j) + 1); });
    }
    parallelFor(lines.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t c = 0; c < needed[i]; ++c) sums_[i].push_back(lines_[i].rss(counts_[c]));
      }
    });
  }

  const std::vector<int>& counts() const { return counts_; }

  /// Number of candidates to try for a line: those up to its window's useful spacing, as far as the line allows.
  std::size_t tried(std::size_t line) const {
    const auto& sums = sums_[line];
    const auto refused = std::find_if(sums.begin(), sums.end(), [](double rss) { return std::isnan(rss); });
    return std::min(tried_[line], static_cast<std::size_t>(refused - sums.begin()));
  }

  /// The candidate of line `other` whose spans are nearest in length to those of `candidate` on `line`.
  std::size_t matching(std::size_t line, std::size_t candidate, std::size_t other) const {
    const double spans = (counts_[candidate] - degree) * length(lines_[other]) / length(lines_[line]);
    const auto above = std::lower_bound(counts_.begin(), counts_.end(), spans + degree - 1e-9);
    if (above == counts_.begin()) return 0;
    if (above == counts_.end()) return counts_.size() - 1;
    const auto index = static_cast<std::size_t>(above - counts_.begin());
    const double high = counts_[index] - degree;
    const double low = counts_[index - 1] - degree;
    return spans * spans < low * high ? index - 1 : index;
  }

  /// NaN when not allowed or not tried.
  double rss(std::size_t line, std::size_t candidate) const {
    const auto& sums = sums_[line];
    return candidate < sums.size() ? sums[candidate] : std::numeric_limits<double>::quiet_NaN();
  }

private:
  /// Number of candidates with up to `density` spans per unit, at least 1.
  std::size_t candidatesUpTo(std::size_t line, double density) const {
    const double largest = density * length(lines_[line]) + degree;
    const auto above = std::upper_bound(counts_.begin() + 1, counts_.end(), largest + 1e-9);
    return static_cast<std::size_t>(above - counts_.begin());
  }

  const std::vector<LineMoments>& lines_;
  std::vector<int> counts_;
  std::vector<std::vector<double>> sums_;
  std::vector<std::size_t> tried_;
};

/// What the lines of a pool have together at each candidate of the line in its middle.
struct Pool {
  std::vector<double> rss;
  std::vector<double> parameters;
  double samples = 0.0;

  explicit Pool(std::size_t candidates) : rss(candidates, 0.0), parameters(candidates, 0.0) {}

  /// Adds a neighbour, unless it does not allow one of the candidates.
  void add(const ResidualTable& table, std::size_t line, std::size_t other, double other_samples) {
    std::vector<std::size_t> matches(rss.size());
    for (std::size_t c = 0; c < rss.size(); ++c) {
      matches[c] = table.matching(line, c, other);
      if (std::isnan(table.rss(other, matches[c]))) return;
    }
    for (std::size_t c = 0; c < rss.size(); ++c) {
      rss[c] += table.rss(other, matches[c]);
      parameters[c] += table.counts()[matches[c]];
    }
    samples += other_samples;
  }

  std::size_t best(double noise) const {
    std::size_t best = 0;
    double best_score = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < rss.size(); ++c) {
      const double score = criterion(samples, rss[c], parameters[c], noise);
      if (score < best_score) {
        best_score = score;
        best = c;
      }
    }
    return best;
  }
};

}  // namespace

std::vector<int> chooseControlPoints(const std::vector<LineMoments>& lines, const CurveFitOptions& options,
                                     int threads) {
  scan_to_path::validate(options, "curve fit");
  const ResidualTable table(lines, options, threads);
  const auto window = static_cast<std::size_t>(options.window);
  std::vector<int> chosen(lines.size(), 0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t candidates = table.tried(i);
    if (candidates == 0) continue;
    Pool pool(candidates);
    forPool(lines, i, window, [&](std::size_t j) { pool.add(table, i, j, static_cast<double>(lines[j].samples())); });
    chosen[i] = table.counts()[pool.best(options.noise)];
  }
  return chosen;
}

}  // namespace scan_to_path::nurbs
