// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/surface_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "scan_to_path/nurbs/height_surface.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "support/expect_input_error.h"
#include "support/spline_lines.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;
using test::SampledLine;

std::vector<HeightSamples> views(const std::vector<SampledLine>& lines) {
  std::vector<HeightSamples> result;
  for (const SampledLine& line : lines) result.push_back(line.heights());
  return result;
}

struct NormalErrors {
  double mean = 0.0;  // [deg]
  double max = 0.0;   // [deg]
};

NormalErrors normalErrors(const Surface& surface, const std::vector<SampledLine>& lines, double sign = 1.0) {
  const HeightSurface heights(surface);
  const geometry::SPart part;
  NormalErrors errors;
  std::size_t count = 0;
  for (const SampledLine& line : lines) {
    for (std::size_t i = 0; i < line.x.size(); i += 11, ++count) {
      HeightDerivatives h = heights.at(line.x[i], line.y[i]);
      h.u *= sign;
      const double angle = geometry::angleBetween(heightNormal(h), part.at(line.x[i], line.y[i]).normal) * 180.0 / M_PI;
      errors.mean += angle;
      errors.max = std::max(errors.max, angle);
    }
  }
  errors.mean /= static_cast<double>(count);
  return errors;
}

/// The bars for normals: fitted surface in the mean, the general ones for the maximum.
bool meetsTheBars(const NormalErrors& errors) { return errors.mean <= 0.01 && errors.max <= 0.2; }

/// Dense QR on the tensor-product collocation matrix.
Eigen::VectorXd denseHeights(const std::vector<SampledLine>& lines, const Surface& surface) {
  std::size_t samples = 0;
  for (const SampledLine& line : lines) samples += line.x.size();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(samples),
                                            static_cast<Eigen::Index>(surface.countU() * surface.countV()));
  Eigen::VectorXd w(A.rows());
  Eigen::Index row = 0;
  for (const SampledLine& line : lines) {
    for (std::size_t s = 0; s < line.x.size(); ++s, ++row) {
      double basis_u[4];
      double basis_v[4];
      const std::size_t span_u = findSpan(surface.knots_u, 3, line.x[s]);
      const std::size_t span_v = findSpan(surface.knots_v, 3, line.y[s]);
      basisFunctions(surface.knots_u, 3, span_u, line.x[s], basis_u);
      basisFunctions(surface.knots_v, 3, span_v, line.y[s], basis_v);
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
          const std::size_t column = (span_u - 3 + i) * surface.countV() + span_v - 3 + j;
          A(row, static_cast<Eigen::Index>(column)) = basis_u[i] * basis_v[j];
        }
      }
      w(row) = line.z[s];
    }
  }
  return A.colPivHouseholderQr().solve(w);
}

/// Scattered heights in rough rows over [0, 0.2] x [0, 0.1] with a gentle wave.
std::vector<SampledLine> scatteredLines(Random& random, int rows, int samples) {
  std::vector<SampledLine> lines(static_cast<std::size_t>(rows));
  for (int r = 0; r < rows; ++r) {
    for (int i = 0; i < samples; ++i) {
      const double x = 0.2 * random.uniform();
      const double y = 0.1 * (r + random.uniform()) / rows;
      const double height = 0.5 + 0.01 * std::sin(40.0 * x + 20.0 * y);
      lines[static_cast<std::size_t>(r)].add(x, x, y, height + 1e-4 * random.gaussian());
    }
  }
  return lines;
}

TEST(FitHeightSurface, AgreesWithDenseQr) {
  Random random(1);
  for (const auto& [count_u, count_v] : {std::pair{4, 4}, {9, 5}, {5, 9}, {12, 10}}) {
    const auto lines = scatteredLines(random, 20, 60);
    const SurfaceFit fit = fitHeightSurface(views(lines), count_u, count_v);
    const Eigen::VectorXd oracle = denseHeights(lines, fit.surface);
    double largest = 0.0;
    for (std::size_t i = 0; i < fit.surface.control_points.size(); ++i) {
      largest = std::max(largest, std::abs(fit.surface.control_points[i].z() - oracle(static_cast<Eigen::Index>(i))));
    }
    // The thin-plate term shrinks a patch's highest polynomials, of size 1e-2 at most, by 1e-5, and a corner's control
    // point takes several times that; the noise of 1e-4 m is a hundred times the limit.
    EXPECT_LT(largest, 1e-6) << count_u << " x " << count_v;
    EXPECT_EQ(fit.parameters, count_u * count_v);
  }
}

TEST(FitHeightSurface, ReproducesACubicExactly) {
  Random random(2);
  auto lines = scatteredLines(random, 12, 50);
  const auto cubic = [](double x, double y) { return 0.3 + 0.5 * x - 0.2 * y + 3.0 * x * y; };
  for (SampledLine& line : lines) {
    for (std::size_t i = 0; i < line.x.size(); ++i) line.z[i] = cubic(line.x[i], line.y[i]);
  }
  const SurfaceFit fit = fitHeightSurface(views(lines));
  const HeightSurface heights(fit.surface);
  // 1e-8 of the height range of 0.2 m, and as much for the thin-plate energy of x y, 1e-10 times its factor of 100.
  for (const SampledLine& line : lines) {
    for (std::size_t i = 0; i < line.x.size(); ++i) EXPECT_NEAR(heights.height(line.x[i], line.y[i]), line.z[i], 1e-8);
  }
  EXPECT_LT(fit.rms, 1e-8);
}

class FitHeightSurfaceOnSPart : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(FitHeightSurfaceOnSPart, NormalsMeetTheBars) {
  std::vector<double> uneven = {0.0};
  while (uneven.size() < 41) uneven.push_back(uneven.back() + (uneven.size() % 2 == 0 ? 0.005 : 0.003));
  for (const auto& rows : {test::sPartRows(), uneven}) {
    const auto lines = test::sPartLines(4800, 10e-6, GetParam(), rows);
    const SurfaceFit fit = fitHeightSurface(views(lines));
    const NormalErrors errors = normalErrors(fit.surface, lines);
    RecordProperty("mean_deg", std::to_string(errors.mean));
    RecordProperty("max_deg", std::to_string(errors.max));
    EXPECT_TRUE(meetsTheBars(errors)) << errors.mean << " deg mean, " << errors.max << " deg max";
    EXPECT_NEAR(fit.sigma, 10e-6, 10e-6 * 3.0 / std::sqrt(2.0 * 41 * 4800));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, FitHeightSurfaceOnSPart, ::testing::Range<std::uint64_t>(1, 6));

TEST(FitHeightSurfaceBars, FailForASignNoiseAndARowMissedOut) {
  auto lines = test::sPartLines(4800, 10e-6, 1, test::sPartRows());
  EXPECT_FALSE(meetsTheBars(normalErrors(fitHeightSurface(views(lines)).surface, lines, -1.0)));
  const auto noisy = test::sPartLines(4800, 40e-6, 1, test::sPartRows());
  EXPECT_FALSE(meetsTheBars(normalErrors(fitHeightSurface(views(noisy)).surface, lines)));
  for (double& z : lines[17].z) z += 0.5e-3;
  EXPECT_FALSE(meetsTheBars(normalErrors(fitHeightSurface(views(lines)).surface, lines)));
}

TEST(FitHeightSurface, CellsWithoutSamplesAreBridgedSmoothly) {
  auto lines = test::sPartLines(1200, 10e-6, 3, test::sPartRows());
  for (SampledLine& line : lines) {  // a hole of 40 mm and a corner cut off
    SampledLine kept;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      const double x = line.x[i];
      const double y = line.y[i];
      const bool hole = std::hypot(x - 0.1, y - 0.08) < 0.02;
      if (!hole && x + y > 0.06) kept.add(x, x, y, line.z[i]);
    }
    line = kept;
  }
  const SurfaceFit fit = fitHeightSurface(views(lines));
  const HeightSurface heights(fit.surface);
  const geometry::SPart part;
  const NormalErrors errors = normalErrors(fit.surface, lines);
  EXPECT_LE(errors.mean, 0.02);  // a quarter of the samples: twice the bar
  // In the hole's middle a thin plate over a radius of 20 mm misses w'''' r^4 / 64, 20 um, and follows noisy slopes.
  EXPECT_NEAR(heights.height(0.1, 0.08), part.jet(0.1, 0.08).z, 1e-4);
  EXPECT_LE(fit.parameters, fit.count_u * fit.count_v);
  const SurfaceFit fine = fitHeightSurface(views(lines), 60, 40);
  EXPECT_TRUE(std::isfinite(fine.rms));
  EXPECT_LT(fine.parameters, 60 * 40);
}

TEST(FitHeightSurface, FewLinesAreEnough) {
  for (const std::vector<double>& rows : {std::vector<double>{0.0, 0.004}, {0.0, 0.004, 0.008}}) {
    const auto lines = test::sPartLines(2000, 0.0, 1, rows);
    const SurfaceFit fit = fitHeightSurface(views(lines));
    EXPECT_EQ(fit.count_v, 4);
    EXPECT_LT(fit.rms, 1e-6);
  }
}

/// Roof ridges along v every 7 mm: creases ask for knots as fine as they can get.
std::vector<SampledLine> creasedLines() {
  std::vector<SampledLine> lines(31);
  for (std::size_t r = 0; r < lines.size(); ++r) {
    for (int i = 0; i < 1500; ++i) {
      const double x = 1e-4 * i;
      lines[r].add(x, x, 0.002 * static_cast<double>(r), 0.2 * std::abs(std::remainder(x, 0.007)));
    }
  }
  return lines;
}

TEST(FitHeightSurface, TakesMoreControlPointsWhenCreasesDemandThem) {
  const auto lines = creasedLines();
  SurfaceFitOptions few;
  few.max_control_points = 64;
  const SurfaceFit coarse = fitHeightSurface(views(lines), few);
  const SurfaceFit fine = fitHeightSurface(views(lines));
  EXPECT_LE(coarse.count_u, 64);
  EXPECT_GT(fine.count_u, 128);
  EXPECT_LE(fine.count_u, 256);
  // A spline rounds a crease off over its span: the residual falls with the span, its RMS faster.
  EXPECT_LT(fine.rms, 0.5 * coarse.rms);
}

TEST(FitHeightSurface, PiecesOfALineCountOnce) {
  const auto lines = test::sPartLines(600, 0.0, 1, {0.0, 0.02, 0.04, 0.06, 0.08, 0.1});
  std::vector<HeightSamples> pieces;
  for (std::size_t r = 0; r < lines.size(); ++r) {
    const HeightSamples line = lines[r].heights();
    for (std::size_t k = 0; k < 6; ++k) {
      pieces.push_back({line.u + 100 * k, line.v + 100 * k, line.w + 100 * k, 100, static_cast<int>(r)});
    }
  }
  EXPECT_EQ(fitHeightSurface(pieces).count_v, 4);  // two for every three of six lines
}

TEST(FitHeightSurface, DirectionsCanBeExchanged) {
  const auto lines = test::sPartLines(600, 10e-6, 4, test::sPartRows());
  // 16 and 8 spans: knots that lie on both grids of cells, the 128 along lines and the 64 across them.
  std::vector<HeightSamples> exchanged = views(lines);
  for (HeightSamples& line : exchanged) std::swap(line.u, line.v);
  const HeightSurface a(fitHeightSurface(views(lines), 19, 11).surface);
  const HeightSurface b(fitHeightSurface(exchanged, 11, 19).surface);
  for (double x = 0.0; x <= 0.24; x += 0.017) {
    for (double y = 0.0; y <= 0.16; y += 0.013) EXPECT_NEAR(a.height(x, y), b.height(y, x), 1e-11);
  }
}

TEST(FitHeightSurface, RefusesBadInput) {
  const auto lines = test::sPartLines(100, 0.0, 5, {0.0, 0.01, 0.02, 0.03, 0.04, 0.05});
  expectInputError([] { fitHeightSurface({}); }, "number of samples is 0");
  expectInputError([] { fitHeightSurface({HeightSamples{}}); }, "number of samples is 0");
  expectInputError([&] { fitHeightSurface({lines[1].heights()}); }, "range of v");
  expectInputError([&] { fitHeightSurface(views(lines), 3, 4); }, "number of control points is 3");
  expectInputError([&] { fitHeightSurface(views(lines), 4, 260); }, "number of control points is 260");
  for (auto SampledLine::*member : {&SampledLine::x, &SampledLine::y, &SampledLine::z}) {
    auto bad = lines;
    (bad[3].*member)[17] = std::numeric_limits<double>::quiet_NaN();
    expectInputError([&] { fitHeightSurface(views(bad)); }, "of sample 17 of line 3");
    (bad[3].*member)[17] = -std::numeric_limits<double>::infinity();
    expectInputError([&] { fitHeightSurface(views(bad)); }, "of sample 17 of line 3");
  }
  SurfaceFitOptions options;
  options.max_control_points = 3;
  expectInputError([&] { fitHeightSurface(views(lines), options); }, "max_control_points");
}

TEST(SurfaceFit, StopsBetweenFitsWhenAsked) {
  const auto lines = test::sPartLines(200, 10e-6, 1, test::sPartRows());
  const std::atomic<bool> cancelled{true};
  EXPECT_THROW(fitHeightSurface(views(lines), {}, Progress({}, &cancelled)), Interrupted);
}

}  // namespace
}  // namespace scan_to_path::nurbs
