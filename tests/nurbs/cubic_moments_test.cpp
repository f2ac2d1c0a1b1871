// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/nurbs/cubic_moments.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "support/spline_lines.h"

namespace scan_to_path::nurbs {
namespace {

using test::SampledLine;

SampledLine noisyLine(Random& random, int samples) {
  SampledLine line;
  for (int i = 0; i < samples; ++i) {
    const double u = 3.0 + 2.0 * random.uniform();  // in [3, 5]: s = u - 4
    line.add(u, 1.0 + u, 2.0 - 0.1 * u * u, 0.5 + 0.01 * random.gaussian());
  }
  return line;
}

double squaredResidual(const SampledLine& line, const Eigen::Matrix<double, 4, 3>& a, int coordinate) {
  const std::vector<double>* values[] = {&line.x, &line.y, &line.z};
  double sum = 0.0;
  for (std::size_t i = 0; i < line.u.size(); ++i) {
    const double s = line.u[i] - 4.0;
    const double p = a(0, coordinate) + s * (a(1, coordinate) + s * (a(2, coordinate) + s * a(3, coordinate)));
    sum += std::pow((*values[coordinate])[i] - p, 2);
  }
  return sum;
}

TEST(CubicMoments, ResidualOfAnyCubicIsTheSumOverItsSamples) {
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    const SampledLine line = noisyLine(random, 4 + 10 * round);
    const CubicResidual residual(accumulate(line.view(), 0, line.u.size(), 4.0, 1.0));
    Eigen::Matrix<double, 4, 3> a;
    for (int k = 0; k < 12; ++k) a(k % 4, k / 4) = random.gaussian();
    const Lanes origin(0.3, -0.2, 0.1, 0.0);
    Lanes coefficients[4];
    for (int k = 0; k < 4; ++k) coefficients[k] = Lanes(a(k, 0), a(k, 1), a(k, 2), 0.0);
    coefficients[0] = coefficients[0] - origin;
    const Lanes found = residual.of(coefficients, origin);
    // Terms of about ten, squared, as many as samples; a few roundings of 1e-16 each.
    for (int c = 0; c < 3; ++c) {
      const double expected = squaredResidual(line, a, c);
      EXPECT_NEAR(found[static_cast<std::size_t>(c)], expected, 1e-12 * (1.0 + expected)) << round << " " << c;
    }
    EXPECT_EQ(residual.rank(), 4);
  }
}

TEST(CubicMoments, PartsMappedAndAddedAreTheWhole) {
  Random random(2);
  const SampledLine line = noisyLine(random, 200);
  const CubicMoments whole = accumulate(line.view(), 0, 200, 4.0, 1.0);
  // Halves with a parameter of their own, twice as fine, centred elsewhere: s = 0.5 s' + delta.
  CubicMoments sum;
  sum.reference = whole.reference;
  addMapped(sum, accumulate(line.view(), 0, 90, 3.7, 2.0), LocalMap(0.5, -0.3));
  addMapped(sum, accumulate(line.view(), 90, 200, 4.6, 2.0), LocalMap(0.5, 0.6));
  addMapped(sum, CubicMoments(), LocalMap(0.5, 0.1));  // a span without samples adds nothing
  const auto expectNear = [](const Lanes& a, const Lanes& b) {
    // 200 terms of at most 3: roundings stay below 200 x 3 x 1e-16 times the powers' condition, 2^6.
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 4e-12);
  };
  for (int k = 0; k < 4; ++k) expectNear(sum.y[k], whole.y[k]);
  expectNear(sum.squares, whole.squares);
  expectNear(sum.high, whole.high);
  EXPECT_EQ(sum.count(), 200.0);
}

TEST(CubicMoments, RankIsTheNumberOfDifferentParametersUpToFour) {
  Random random(3);
  for (int different = 1; different <= 6; ++different) {
    SampledLine line;
    for (int i = 0; i < 30; ++i) line.add(3.0 + 0.37 * (i % different), random.gaussian(), 0.0, random.gaussian());
    EXPECT_EQ(CubicResidual(accumulate(line.view(), 0, 30, 4.0, 1.0)).rank(), std::min(different, 4));
  }
}

TEST(CubicMoments, FarFromTheOriginTheResidualKeepsItsDigits) {
  // A cubic 100 m off with 1 um of noise: squares of the coordinates themselves would leave 1e4 * 1e-16 = 1e-12 of
  // 200 * 1e-12; relative to a sample of the line they leave 1e-8 of the extent squared, here 1e-12 * 1e-8.
  Random random(4);
  SampledLine line;
  double expected = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double s = -1.0 + 0.01 * i, noise = 1e-6 * random.gaussian();
    line.add(4.0 + s, 100.0, 100.0, 100.0 + 1e-4 * s * s * s + noise);
    expected += noise * noise;
  }
  const CubicResidual residual(accumulate(line.view(), 0, 200, 4.0, 1.0));
  const Lanes cubic[4] = {Lanes(), Lanes(), Lanes(), Lanes(0.0, 0.0, 1e-4, 0.0)};
  const Lanes found = residual.of(cubic, Lanes(100.0, 100.0, 100.0, 0.0));
  // A height of 100 m is rounded to 1.4e-14 m when it is stored: 1e-8 of the noise.
  EXPECT_NEAR(found[2], expected, 1e-6 * expected);
}

}  // namespace
}  // namespace scan_to_path::nurbs
