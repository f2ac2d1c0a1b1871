// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "cubic.h"
#include "fit_criterion.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "span_layout.h"
#include "surface_moments.h"
#include "thin_plate.h"

namespace scan_to_path::nurbs {
namespace {

constexpr std::size_t coarse_cells = 128;
constexpr std::size_t fine_cells = 512;
constexpr std::size_t min_grid_cells = 64;
constexpr int coarse_count = 64;
constexpr int most_control_points = 259;
// Multiplications that one solution of a fit on the fine grid may take: about a second.
constexpr double most_work = 2e9;
// Weight of the thin-plate energy against the data at the scale of a span: see fitHeightSurface. On the fine grid knots
// are as close as rows, and with less a ragged edge, whose patches hold a sample here and there, swings by millimetres.
constexpr double coarse_thin_plate = 1e-10;
constexpr double fine_thin_plate = 1e-5;

std::size_t lineCount(const std::vector<HeightSamples>& lines) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == 0 || lines[i].row < 0 || lines[i].row != lines[i - 1].row) ++count;
  }
  return count;
}

/// Fits of a set of samples with any numbers of control points.
class Fitter {
public:
  Fitter(const std::vector<HeightSamples>& lines, std::size_t max_cells, const Progress& progress = {})
      : progress_(progress),
        moments_(accumulateHeights(lines, cellsU(lines, max_cells), cellsV(lines, max_cells))),
        thin_plate_(max_cells > coarse_cells ? fine_thin_plate : coarse_thin_plate) {}

  double samples() const { return moments_.samples; }

  SurfaceFit fit(int count_u, int count_v) {
    progress_.checkCancelled();
    const int cells_u = static_cast<int>(moments_.grid.cells_u);
    const int cells_v = static_cast<int>(moments_.grid.cells_v);
    const std::vector<int> ends_u = spanEnds(count_u - degree, cells_u);
    const std::vector<int> ends_v = spanEnds(count_v - degree, cells_v);
    auto& merged = merged_u_[count_u];
    if (merged.cells.empty()) merged = mergeU(moments_.grid, ends_u);
    SurfaceFit result;
    result.count_u = count_u;
    result.count_v = count_v;
    result.samples = static_cast<std::size_t>(moments_.samples);
    result.surface.knots_u = cubicKnots(ends_u, cells_u, moments_.first_u, moments_.last_u);
    result.surface.knots_v = cubicKnots(ends_v, cells_v, moments_.first_v, moments_.last_v);
    solve(mergeV(merged, ends_v), ends_u, ends_v, result);
    return result;
  }

  int largestU() const { return static_cast<int>(moments_.grid.cells_u / 2) + degree; }
  int largestV() const { return static_cast<int>(moments_.grid.cells_v / 2) + degree; }

private:
  static std::size_t cells(std::size_t wanted, std::size_t max_cells) {
    return powerOfTwoAtMost(std::min(max_cells, std::max(min_grid_cells, wanted)));
  }
  static std::size_t cellsU(const std::vector<HeightSamples>& lines, std::size_t max_cells) {
    std::size_t longest = 0;
    for (const HeightSamples& line : lines) longest = std::max(longest, line.count);
    return cells(longest, max_cells);
  }
  static std::size_t cellsV(const std::vector<HeightSamples>& lines, std::size_t max_cells) {
    return cells((max_cells > coarse_cells ? 4 : 2) * lineCount(lines), max_cells);
  }

  void solve(const MomentGrid& patches, const std::vector<int>& ends_u, const std::vector<int>& ends_v,
             SurfaceFit& result) const {
    const auto count_u = static_cast<std::size_t>(result.count_u);
    const auto count_v = static_cast<std::size_t>(result.count_v);
    // The shorter direction runs fastest: the band is three rows of it wide.
    const std::size_t stride_u = count_v <= count_u ? count_v : 1;
    const std::size_t stride_v = count_v <= count_u ? 1 : count_u;
    BandedMatrix A(count_u * count_v, 3 * (stride_u + stride_v));
    std::vector<double> rhs(A.size(), 0.0);
    std::vector<char> supported(A.size(), 0);
    for (std::size_t i = 0; i < patches.cells_u; ++i) {
      const CubicSpanMatrix basis_u = spanMatrix(ends_u, static_cast<int>(i));
      for (std::size_t j = 0; j < patches.cells_v; ++j) {
        if (patches.at(i, j).count() == 0.0) continue;
        const std::size_t first = i * stride_u + j * stride_v;
        addPatch(patches.at(i, j), basis_u, spanMatrix(ends_v, static_cast<int>(j)), first, stride_u, stride_v, A, rhs);
        for (std::size_t k = 0; k < 16; ++k) supported[first + (k / 4) * stride_u + (k % 4) * stride_v] = 1;
      }
    }
    result.parameters = static_cast<double>(std::count(supported.begin(), supported.end(), 1));
    const BandedMatrix data = A;
    const double area = (moments_.last_u - moments_.first_u) * (moments_.last_v - moments_.first_v);
    const double patch = area / static_cast<double>(patches.cells_u * patches.cells_v);
    addThinPlate(result.surface, thin_plate_ * moments_.samples / area * patch * patch, stride_u, stride_v, A);
    finish(data, std::move(A), rhs, stride_u, stride_v, result);
  }

  /// c^T A c of a symmetric matrix of which the lower triangle is stored.
  static double quadraticForm(const BandedMatrix& A, const std::vector<double>& c) {
    double sum = 0.0;
    for (std::size_t i = 0; i < A.size(); ++i) {
      double below = 0.0;
      for (std::size_t j = i - std::min(i, A.bandwidth()); j < i; ++j) below += A.at(i, j) * c[j];
      sum += c[i] * (2.0 * below + A.at(i, i) * c[i]);
    }
    return sum;
  }

  void finish(const BandedMatrix& data, BandedMatrix A, const std::vector<double>& rhs, std::size_t stride_u,
              std::size_t stride_v, SurfaceFit& result) const {
    const BandedCholesky cholesky(std::move(A));
    if (!cholesky.positiveDefinite()) {
      result.rms = result.sigma = std::numeric_limits<double>::infinity();
      return;
    }
    std::vector<double> c = rhs;
    cholesky.solve(c.data(), 1);
    double cross = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) cross += c[i] * rhs[i];
    // Rounding of the difference of two sums of squares; below this the residual says nothing.
    const double floor = 64.0 * std::numeric_limits<double>::epsilon() * moments_.squares;
    const double rss = std::max(floor, moments_.squares - 2.0 * cross + quadraticForm(data, c));
    result.rms = std::sqrt(rss / moments_.samples);
    result.sigma = std::sqrt(rss / std::max(1.0, moments_.samples - result.parameters));
    const std::vector<double> greville_u = grevilleAbscissae(result.surface.knots_u, degree);
    const std::vector<double> greville_v = grevilleAbscissae(result.surface.knots_v, degree);
    for (std::size_t i = 0; i < greville_u.size(); ++i) {
      for (std::size_t j = 0; j < greville_v.size(); ++j) {
        const double w = c[i * stride_u + j * stride_v] + moments_.reference;
        result.surface.control_points.emplace_back(greville_u[i], greville_v[j], w);
      }
    }
  }

  Progress progress_;
  HeightMoments moments_;
  double thin_plate_;
  std::map<int, MomentGrid> merged_u_;
};

double surfaceScore(const SurfaceFit& fit, double noise) {
  const double n = static_cast<double>(fit.samples);
  const bool is_smallest = fit.count_u + fit.count_v <= 2 * (degree + 1);
  if (2.0 * fit.parameters > n && !is_smallest) return std::numeric_limits<double>::infinity();
  return criterion(n, fit.rms * fit.rms * n, std::min(fit.parameters, 0.5 * n), noise);
}

/// Climbs down the criterion over a ladder of counts in both directions.
class Search {
public:
  Search(Fitter& fitter, double noise, int limit_u, int limit_v)
      : fitter_(fitter), noise_(noise), counts_u_(ladder(limit_u)), counts_v_(ladder(limit_v)) {}

  SurfaceFit best() {
    Place place = {start(counts_u_), start(counts_v_)};
    // Two steps ahead, so that a small bump of the criterion does not end the search.
    const Place moves[] = {{1, 0}, {0, 1}, {1, 1}, {-1, 0}, {0, -1}, {1, -1}, {-1, 1}, {2, 0}, {0, 2}};
    for (bool improved = true; improved;) {
      improved = false;
      const Place from = place;
      for (const Place& move : moves) {
        const Place to = {from.first + move.first, from.second + move.second};
        if (score(to) < score(place)) {
          place = to;
          improved = true;
        }
      }
    }
    return fits_.at(place);
  }

  /// The largest counts that are tried.
  int largestU() const { return counts_u_.back(); }
  int largestV() const { return counts_v_.back(); }

private:
  using Place = std::pair<int, int>;

  static std::vector<int> ladder(int limit) {
    std::vector<int> counts;
    for (int p = degree + 1; p <= limit; p = std::max(p + 1, p * 5 / 4)) counts.push_back(p);
    return counts;
  }
  static int start(const std::vector<int>& counts) { return std::min(4, static_cast<int>(counts.size()) - 1); }

  double score(const Place& place) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (place.first < 0 || place.first >= static_cast<int>(counts_u_.size())) return infinity;
    if (place.second < 0 || place.second >= static_cast<int>(counts_v_.size())) return infinity;
    auto known = fits_.find(place);
    if (known == fits_.end()) {
      const int count_u = counts_u_[static_cast<std::size_t>(place.first)];
      const int count_v = counts_v_[static_cast<std::size_t>(place.second)];
      known = fits_.emplace(place, fitter_.fit(count_u, count_v)).first;
    }
    return surfaceScore(known->second, noise_);
  }

  Fitter& fitter_;
  double noise_;
  std::vector<int> counts_u_;
  std::vector<int> counts_v_;
  std::map<Place, SurfaceFit> fits_;
};

/// Climbs from a fit to finer ones as long as each is worth its cost: the criterion falls by a tenth.
class Climb {
public:
  Climb(Fitter& fitter, double noise, int limit_u, int limit_v)
      : fitter_(fitter), noise_(noise), limit_u_(limit_u), limit_v_(limit_v) {}

  SurfaceFit from(int first_u, int first_v) {
    SurfaceFit best = fitter_.fit(first_u, first_v);
    constexpr double worthwhile = 0.9;
    for (bool improved = true; improved;) {
      improved = false;
      const int count_u = std::min(limit_u_, best.count_u * 3 / 2);
      const int count_v = std::min(limit_v_, best.count_v * 3 / 2);
      const double score = surfaceScore(best, noise_);
      for (const auto& [u, v] : {std::pair{count_u, count_v}, {count_u, best.count_v}, {best.count_u, count_v}}) {
        if ((u == best.count_u && v == best.count_v) || work(u, v) > most_work) continue;
        SurfaceFit fit = fitter_.fit(u, v);
        if (!(surfaceScore(fit, noise_) < worthwhile * score)) continue;
        best = std::move(fit);
        improved = true;
        break;
      }
    }
    return best;
  }

private:
  /// Multiplications of a Cholesky factorisation: the squared half bandwidth for every control point.
  static double work(int count_u, int count_v) {
    const double band = 3.0 * (std::min(count_u, count_v) + 1);
    return static_cast<double>(count_u) * count_v * band * band;
  }

  Fitter& fitter_;
  double noise_;
  int limit_u_;
  int limit_v_;
};

}  // namespace

SurfaceFit fitHeightSurface(const std::vector<HeightSamples>& lines, const SurfaceFitOptions& options,
                            const Progress& progress) {
  scan_to_path::validate(options, "surface fit");
  const int rows = static_cast<int>(std::min<std::size_t>(lineCount(lines), 10000));
  const int limit_v = std::min(options.max_control_points, std::max(degree + 1, 2 * rows / 3));
  Fitter coarse(lines, coarse_cells, progress);
  Search search(coarse, options.noise, std::min({options.max_control_points, coarse.largestU(), coarse_count}),
                std::min({coarse.largestV(), limit_v, coarse_count}));
  const SurfaceFit best = search.best();
  const bool more_u = best.count_u >= search.largestU() && best.count_u < options.max_control_points;
  const bool more_v = best.count_v >= search.largestV() && best.count_v < limit_v;
  if (!more_u && !more_v) return best;
  Fitter fine(lines, fine_cells, progress);
  return Climb(fine, options.noise, std::min(options.max_control_points, fine.largestU()),
               std::min(fine.largestV(), limit_v))
      .from(best.count_u, best.count_v);
}

SurfaceFit fitHeightSurface(const std::vector<HeightSamples>& lines, int count_u, int count_v) {
  for (const int count : {count_u, count_v}) {
    if (count <= degree || count > most_control_points) {
      throw InputError("surface fit", "number of control points", std::to_string(count),
                       "in [" + std::to_string(degree + 1) + ", " + std::to_string(most_control_points) + "]");
    }
  }
  const int coarse_limit = static_cast<int>(coarse_cells / 2) + degree;
  return Fitter(lines, std::max(count_u, count_v) > coarse_limit ? fine_cells : coarse_cells).fit(count_u, count_v);
}

}  // namespace scan_to_path::nurbs
