// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/curve_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/dense_spline_fit.h"
#include "support/expect_input_error.h"
#include "support/spline_lines.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;
using test::SampledLine;

/// Knots of random spacing and samples of random density, a few of them on knots.
struct RandomProblem {
  std::vector<double> knots = {-1.0, -1.0, -1.0, -1.0};
  SampledLine line;

  explicit RandomProblem(Random& random) {
    const int spans = 1 + static_cast<int>(random.uniform(0.0, 20.0));
    for (int i = 0; i < spans; ++i) {
      const double begin = knots.back();
      const double end = begin + random.uniform(0.05, 1.0);
      for (int j = 0; j < 8; ++j) addSample(random, begin + (end - begin) * (j == 0 ? 0.0 : random.uniform()));
      knots.push_back(end);
    }
    knots.insert(knots.end(), 3, knots.back());
    addSample(random, knots.back());
  }

  void addSample(Random& random, double u) {
    line.add(u, 3.0 + random.gaussian(), random.gaussian(), random.gaussian());
  }
};

double difference(const CurveFit& fit, const test::DenseSplineFit& oracle) {
  double largest = 0.0;
  for (std::size_t i = 0; i < fit.curve.control_points.size(); ++i) {
    const Vector3 expected = oracle.control_points.row(static_cast<Eigen::Index>(i)).transpose();
    largest = std::max(largest, (fit.curve.control_points[i] - expected).norm());
  }
  return largest;
}

TEST(LeastSquaresCurve, AgreesWithDenseQrOnRandomKnots) {
  Random random(1);
  for (int round = 0; round < 100; ++round) {
    const RandomProblem problem(random);
    const CurveFit fit = leastSquaresCurve(problem.line.view(), problem.knots);
    const auto oracle = test::denseSplineFit(problem.line.view(), problem.knots);
    ASSERT_TRUE(fit.fitted);
    // Normal equations square the condition of the collocation matrix, which is below 1e3 here: 1e6 * 1e-16 * some 10.
    EXPECT_LT(difference(fit, oracle), 1e-8) << round;
    EXPECT_NEAR(fit.rms * fit.rms * static_cast<double>(fit.samples), oracle.rss, 1e-9 * oracle.rss);
  }
}

TEST(LeastSquaresCurve, ADroppedSampleShowsAgainstTheOracle) {
  Random random(2);
  RandomProblem problem(random);
  const auto oracle = test::denseSplineFit(problem.line.view(), problem.knots);
  LineSamples fewer = problem.line.view();
  fewer.count -= 1;
  EXPECT_GT(difference(leastSquaresCurve(fewer, problem.knots), oracle), 1e-6);
}

TEST(LeastSquaresCurve, ReproducesASpline) {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    RandomProblem problem(random);
    const Curve truth = leastSquaresCurve(problem.line.view(), problem.knots).curve;
    for (std::size_t i = 0; i < problem.line.u.size(); ++i) {
      const Vector3 point = pointAt(truth, problem.line.u[i]);
      problem.line.x[i] = point.x();
      problem.line.y[i] = point.y();
      problem.line.z[i] = point.z();
    }
    const CurveFit fit = leastSquaresCurve(problem.line.view(), problem.knots);
    for (std::size_t i = 0; i < truth.control_points.size(); ++i) {
      EXPECT_LT((fit.curve.control_points[i] - truth.control_points[i]).norm(), 1e-8);
    }
    EXPECT_LT(fit.rms, 1e-7);  // documented floor: 1e-8 of a span's extent, here up to 10
  }
}

TEST(LeastSquaresCurve, OrderOfTheSamplesDoesNotMatter) {
  Random random(4);
  const RandomProblem problem(random);
  SampledLine reversed = problem.line;
  for (auto* array : {&reversed.u, &reversed.x, &reversed.y, &reversed.z}) std::reverse(array->begin(), array->end());
  const CurveFit a = leastSquaresCurve(problem.line.view(), problem.knots);
  const CurveFit b = leastSquaresCurve(reversed.view(), problem.knots);
  EXPECT_EQ(a.largest_gap, b.largest_gap);
  EXPECT_NEAR(a.rms, b.rms, 1e-12);
  for (std::size_t i = 0; i < a.curve.control_points.size(); ++i) {
    EXPECT_LT((a.curve.control_points[i] - b.curve.control_points[i]).norm(), 1e-8);
  }
}

TEST(LeastSquaresCurve, ErrorScalesWithNoiseAndSamples) {
  // Expected squared error of white noise: sigma^2 p / n (spec, limits to be measured against); 400 control points
  // over all lines scatter it by sqrt(2 / 400) = 7 %, so three times that is 21 %.
  constexpr int lines = 20;
  constexpr int count = 20;
  const auto knots = clampedUniformKnots(0.0, 1.0, count, 3);
  for (const std::size_t n : {std::size_t{400}, std::size_t{1600}}) {
    for (const double sigma : {1e-5, 4e-5}) {
      Random random(5);
      double squared = 0.0;
      double sigma_squared = 0.0;
      for (int l = 0; l < lines; ++l) {
        SampledLine line;
        for (std::size_t i = 0; i < n; ++i) {
          const double u = static_cast<double>(i) / static_cast<double>(n - 1);
          line.add(u, u, 0.0, sigma * random.gaussian());
        }
        const CurveFit fit = leastSquaresCurve(line.view(), knots);
        for (const double u : line.u) squared += std::pow(pointAt(fit.curve, u).z(), 2);
        sigma_squared += fit.sigma * fit.sigma;
      }
      const double expected = sigma * sigma * count / static_cast<double>(n);
      EXPECT_NEAR(squared / (lines * static_cast<double>(n)) / expected, 1.0, 0.21);
      EXPECT_NEAR(std::sqrt(sigma_squared / lines) / sigma, 1.0, 3.0 / std::sqrt(2.0 * lines * static_cast<double>(n)));
    }
  }
}

TEST(LeastSquaresCurve, TooFewSamplesAreAResultNotAnError) {
  SampledLine line;
  for (const double u : {0.0, 0.1, 0.2, 0.9, 1.0}) line.add(u, u, 0.0, 0.0);
  EXPECT_FALSE(leastSquaresCurve(line.view(), clampedUniformKnots(0.0, 1.0, 6, 3)).fitted);
  EXPECT_TRUE(leastSquaresCurve(line.view(), clampedUniformKnots(0.0, 1.0, 4, 3)).fitted);
  SampledLine gap;  // enough samples, but one control point has none in its support
  for (int i = 0; i < 40; ++i) gap.add(i < 20 ? 0.01 * i : 0.8 + 0.01 * (i - 20), 0.0, 0.0, 0.0);
  EXPECT_FALSE(leastSquaresCurve(gap.view(), clampedUniformKnots(0.0, 1.0, 23, 3)).fitted);
}

TEST(LeastSquaresCurve, RefusesBadInput) {
  const auto knots = clampedUniformKnots(0.0, 1.0, 5, 3);
  Random random(6);
  SampledLine good;
  for (int i = 0; i <= 20; ++i) good.add(i / 20.0, random.gaussian(), random.gaussian(), random.gaussian());
  EXPECT_TRUE(leastSquaresCurve(good.view(), knots).fitted);
  expectInputError([&] { leastSquaresCurve(LineSamples{}, knots); }, "number of samples is 0");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SampledLine line = good;
    line.z[7] = bad;
    expectInputError([&] { leastSquaresCurve(line.view(), knots); }, "z of sample 7");
    line = good;
    line.u[20] = bad;
    expectInputError([&] { leastSquaresCurve(line.view(), knots); }, "u of sample 20");
  }
  SampledLine outside = good;
  outside.u[20] = 1.5;
  expectInputError([&] { leastSquaresCurve(outside.view(), knots); }, "parameter of a sample");
  expectInputError([&] { leastSquaresCurve(good.view(), {0.0, 1.0}); }, "curve fit");
}

}  // namespace
}  // namespace scan_to_path::nurbs
