// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "scan_to_path/nurbs/control_point_choice.h"
#include "scan_to_path/nurbs/height_surface.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "scan_to_path/nurbs/surface_fit.h"
#include "support/spline_lines.h"

namespace {

using namespace scan_to_path;
using nurbs::Vector3;

/// Samples of a known spline without noise, ten for each control point: every method's error is its own.
struct Problem {
  std::vector<double> knots;
  std::vector<Vector3> truth;
  test::SampledLine line;

  explicit Problem(int samples) : knots(nurbs::clampedUniformKnots(0.0, 1.0, samples / 10, 3)) {
    Random random(1);
    for (int i = 0; i < samples / 10; ++i) truth.emplace_back(random.gaussian(), random.gaussian(), random.gaussian());
    nurbs::Curve curve;
    curve.knots = knots;
    curve.control_points = truth;
    for (int i = 0; i < samples; ++i) {
      const double u = (i + random.uniform()) / samples;
      const Vector3 p = nurbs::pointAt(curve, u);
      line.add(u, p.x(), p.y(), p.z());
    }
  }

  double error(const std::vector<Vector3>& control_points) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) largest = std::max(largest, (control_points[i] - truth[i]).norm());
    return largest;
  }

  double error(const Eigen::MatrixXd& control_points) const {
    std::vector<Vector3> points;
    for (Eigen::Index i = 0; i < control_points.rows(); ++i) points.emplace_back(control_points.row(i).transpose());
    return error(points);
  }
};

const Problem& problem(std::int64_t samples) {
  static const Problem small(20000);
  static const Problem large(200000);
  return samples == 20000 ? small : large;
}

struct SparseSystem {
  Eigen::SparseMatrix<double> A;
  Eigen::MatrixXd P;
};

SparseSystem sparseSystem(const Problem& problem) {
  const auto n = static_cast<Eigen::Index>(problem.line.u.size());
  SparseSystem system{Eigen::SparseMatrix<double>(n, static_cast<Eigen::Index>(problem.truth.size())),
                      Eigen::MatrixXd(n, 3)};
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * problem.line.u.size());
  for (Eigen::Index row = 0; row < n; ++row) {
    const auto i = static_cast<std::size_t>(row);
    const double u = problem.line.u[i];
    const std::size_t span = nurbs::findSpan(problem.knots, 3, u);
    double basis[4];
    nurbs::basisFunctions(problem.knots, 3, span, u, basis);
    for (int j = 0; j < 4; ++j) entries.emplace_back(row, static_cast<Eigen::Index>(span) - 3 + j, basis[j]);
    system.P.row(row) << problem.line.x[i], problem.line.y[i], problem.line.z[i];
  }
  system.A.setFromTriplets(entries.begin(), entries.end());
  return system;
}

/// The textbook fit: basis functions sample by sample into banded normal equations, unblocked Cholesky, x, y and z.
std::vector<Vector3> plainFit(const Problem& problem) {
  const std::size_t n = problem.truth.size();
  std::vector<double> A(4 * n, 0.0);
  std::vector<Vector3> X(n, Vector3::Zero());
  std::size_t span = 3;
  for (std::size_t i = 0; i < problem.line.u.size(); ++i) {
    const double u = problem.line.u[i];
    while (span + 1 < n && u >= problem.knots[span + 1]) ++span;
    double basis[4];
    nurbs::basisFunctions(problem.knots, 3, span, u, basis);
    const Vector3 p(problem.line.x[i], problem.line.y[i], problem.line.z[i]);
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c <= r; ++c) A[4 * (span - 3 + r) + c + 3 - r] += basis[r] * basis[c];
      X[span - 3 + r] += basis[r] * p;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i - std::min<std::size_t>(i, 3); j <= i; ++j) {
      double sum = A[4 * i + j + 3 - i];
      for (std::size_t k = i - std::min<std::size_t>(i, 3); k < j; ++k) {
        sum -= A[4 * i + k + 3 - i] * A[4 * j + k + 3 - j];
      }
      A[4 * i + j + 3 - i] = j < i ? sum / A[4 * j + 3] : std::sqrt(sum);
      if (j < i) X[i] -= A[4 * i + j + 3 - i] * X[j];
    }
    X[i] /= A[4 * i + 3];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < std::min(n, i + 4); ++j) X[i] -= A[4 * j + i + 3 - j] * X[j];
    X[i] /= A[4 * i + 3];
  }
  return X;
}

/// Calibration loop: processor time of the textbook fit, which takes 0.41 and 4.3 ms on the machine that the reference
/// figures are from.
double calibration(const Problem& problem) {
  double best = 1e9;
  for (int i = 0; i < 20; ++i) {
    const std::clock_t start = std::clock();
    benchmark::DoNotOptimize(plainFit(problem).data());
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

void curveCalibrationAndReference(benchmark::State& state) {
  const Problem& p = problem(state.range(0));
  std::vector<Vector3> X;
  for (auto _ : state) X = plainFit(p);
  const double scale = calibration(p) / (state.range(0) == 20000 ? 0.41e-3 : 4.3e-3);
  state.counters["max_error_m"] = p.error(X);
  state.counters["machine_scale"] = scale;
  state.counters["reference_figure_scipy_banded_s"] = scale * (state.range(0) == 20000 ? 10e-3 : 0.99);
}
BENCHMARK(curveCalibrationAndReference)->Arg(20000)->Arg(200000)->Unit(benchmark::kMillisecond);

void curveLeastSquares(benchmark::State& state) {
  const Problem& p = problem(state.range(0));
  nurbs::CurveFit fit;
  for (auto _ : state) fit = nurbs::leastSquaresCurve(p.line.view(), p.knots);
  state.counters["max_error_m"] = p.error(fit.curve.control_points);
}
BENCHMARK(curveLeastSquares)->Arg(20000)->Arg(200000)->Unit(benchmark::kMillisecond);

/// The rival at its best: normal equations in sparse storage, no reordering, which a band matrix does not need.
void curveEigenSimplicialLdlt(benchmark::State& state) {
  const Problem& p = problem(state.range(0));
  Eigen::MatrixXd X;
  for (auto _ : state) {
    const SparseSystem system = sparseSystem(p);
    const Eigen::SparseMatrix<double> N = system.A.transpose() * system.A;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver(N);
    X = solver.solve(system.A.transpose() * system.P);
  }
  state.counters["max_error_m"] = p.error(X);
}
BENCHMARK(curveEigenSimplicialLdlt)->Arg(20000)->Arg(200000)->Unit(benchmark::kMillisecond);

/// White noise over the S part, `samples` per line.
const std::vector<test::SampledLine>& partLines(std::int64_t samples) {
  static std::vector<test::SampledLine> lines;
  if (lines.empty() || lines[0].u.size() != static_cast<std::size_t>(samples)) {
    lines = test::sPartLines(static_cast<std::size_t>(samples), 10e-6, 1, test::sPartRows());
  }
  return lines;
}

void linesMomentsChoiceAndFit(benchmark::State& state) {
  const auto& lines = partLines(state.range(0));
  std::vector<nurbs::CurveFit> fits;
  for (auto _ : state) {
    std::vector<nurbs::LineMoments> moments;
    for (const auto& line : lines) moments.emplace_back(line.view());
    const std::vector<int> counts = nurbs::chooseControlPoints(moments, {});
    fits.clear();
    for (std::size_t i = 0; i < moments.size(); ++i) fits.push_back(moments[i].fit(counts[i]));
  }
  const geometry::SPart part;
  double squared = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const double u : lines[i].u) {
      squared += std::pow(nurbs::pointAt(fits[i].curve, u).z() - part.jet(u, lines[i].y[0]).z, 2);
    }
  }
  const double samples = static_cast<double>(lines.size()) * static_cast<double>(state.range(0));
  state.counters["rms_m"] = std::sqrt(squared / samples);
  state.counters["per_sample"] =
      benchmark::Counter(samples, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(linesMomentsChoiceAndFit)->Arg(2400)->Arg(4800)->Arg(24390)->Unit(benchmark::kMillisecond);

void surfaceChoiceAndFit(benchmark::State& state) {
  const auto& lines = partLines(state.range(0));
  std::vector<nurbs::HeightSamples> views;
  for (const auto& line : lines) views.push_back(line.heights());
  nurbs::SurfaceFit fit;
  for (auto _ : state) fit = nurbs::fitHeightSurface(views);
  const geometry::SPart part;
  const nurbs::HeightSurface heights(fit.surface);
  double angle = 0.0;
  double largest = 0.0;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.u.size(); ++i) {
      const double error = geometry::angleBetween(nurbs::heightNormal(heights.at(line.x[i], line.y[i])),
                                                  part.at(line.x[i], line.y[i]).normal);
      angle += error;
      largest = std::max(largest, error);
    }
  }
  const double samples = static_cast<double>(lines.size()) * static_cast<double>(state.range(0));
  state.counters["normal_mean_deg"] = angle / samples * 180.0 / M_PI;
  state.counters["normal_max_deg"] = largest * 180.0 / M_PI;
  state.counters["per_sample"] =
      benchmark::Counter(samples, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(surfaceChoiceAndFit)->Arg(4800)->Arg(24390)->Unit(benchmark::kMillisecond);

void heightSurfaceAt(benchmark::State& state) {
  const auto& lines = partLines(4800);
  std::vector<nurbs::HeightSamples> views;
  for (const auto& line : lines) views.push_back(line.heights());
  const nurbs::HeightSurface heights(nurbs::fitHeightSurface(views).surface);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(heights.at(lines[20].x[i], lines[20].y[i]));
    i = i + 1 < 4800 ? i + 1 : 0;
  }
}
BENCHMARK(heightSurfaceAt);

}  // namespace
