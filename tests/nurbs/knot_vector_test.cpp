// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/knot_vector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;

/// Cox - de Boor recursion as it is defined (eq 4), half-open spans: the oracle.
double coxDeBoor(const std::vector<double>& t, std::size_t i, int p, double u) {
  if (p == 0) return t[i] <= u && u < t[i + 1] ? 1.0 : 0.0;
  const auto q = static_cast<std::size_t>(p);
  const double left = t[i + q] - t[i];
  const double right = t[i + q + 1] - t[i + 1];
  return (left > 0.0 ? (u - t[i]) / left * coxDeBoor(t, i, p - 1, u) : 0.0) +
         (right > 0.0 ? (t[i + q + 1] - u) / right * coxDeBoor(t, i + 1, p - 1, u) : 0.0);
}

std::vector<double> randomKnots(Random& random, int degree, int inner) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  double u = 0.0;
  for (int i = 0; i < inner; ++i) {
    const bool repeat = i > 0 && random.uniform() < 0.2 && knots[knots.size() - static_cast<std::size_t>(degree)] < u;
    u += repeat ? 0.0 : random.uniform(0.1, 1.0);
    knots.push_back(u);
  }
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, u + random.uniform(0.1, 1.0));
  return knots;
}

TEST(FindSpan, SpansAreHalfOpenAndTheLastIsClosed) {
  const std::vector<double> knots = {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3};
  EXPECT_EQ(findSpan(knots, 3, 0.0), 3u);
  EXPECT_EQ(findSpan(knots, 3, 0.999), 3u);
  EXPECT_EQ(findSpan(knots, 3, 1.0), 4u);
  EXPECT_EQ(findSpan(knots, 3, 2.0), 6u);
  EXPECT_EQ(findSpan(knots, 3, 3.0), 6u);
  EXPECT_EQ(findSpan(knots, 3, -5.0), 3u);
  EXPECT_EQ(findSpan(knots, 3, 7.0), 6u);
}

TEST(FindSpan, ParameterThatIsNotANumberStaysInRange) {
  const auto knots = clampedUniformKnots(0.0, 1.0, 9, 3);
  const std::size_t span = findSpan(knots, 3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_GE(span, 3u);
  EXPECT_LE(span, 8u);
}

TEST(BasisFunctions, AgreeWithCoxDeBoor) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const int degree = 1 + static_cast<int>(random.uniform(0.0, 5.0));
    const auto knots = randomKnots(random, degree, 6);
    const double u = random.uniform(knots.front(), knots.back());
    const std::size_t span = findSpan(knots, degree, u);
    double values[max_degree + 1];
    basisFunctions(knots, degree, span, u, values);
    double sum = 0.0;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(degree); ++j) {
      // Both are sums of products of at most 5 factors in [0, 1]: some tens of roundings.
      EXPECT_NEAR(values[j], coxDeBoor(knots, span - static_cast<std::size_t>(degree) + j, degree, u), 1e-13);
      sum += values[j];
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
  }
}

TEST(BasisDerivatives, AgreeWithDividedDifferences) {
  Random random(2);
  constexpr double step = 1e-4;
  for (int round = 0; round < 100; ++round) {
    const int degree = 2 + static_cast<int>(random.uniform(0.0, 4.0));
    const auto knots = randomKnots(random, degree, 5);
    const double u = random.uniform(knots.front(), knots.back());
    const std::size_t span = findSpan(knots, degree, u);
    const std::size_t count = static_cast<std::size_t>(degree) + 1;
    double derivatives[3 * (max_degree + 1)];
    double below[max_degree + 1];
    double above[max_degree + 1];
    basisDerivatives(knots, degree, span, u, 2, derivatives);
    basisFunctions(knots, degree, span, u - step, below);
    basisFunctions(knots, degree, span, u + step, above);
    for (std::size_t j = 0; j < count; ++j) {
      // Truncation h^2 / 6 |B'''| with spans down to 0.1: |B'''| < 1e5, and rounding 1e-16 / h^2 = 1e-8.
      EXPECT_NEAR(derivatives[count + j], (above[j] - below[j]) / (2.0 * step), 1e-3);
      EXPECT_NEAR(derivatives[2 * count + j], (above[j] - 2.0 * derivatives[j] + below[j]) / (step * step), 1e-1);
    }
  }
}

TEST(BasisDerivatives, OrdersAboveTheDegreeAreZero) {
  const auto knots = clampedUniformKnots(0.0, 1.0, 4, 1);
  double derivatives[3 * 2];
  basisDerivatives(knots, 1, findSpan(knots, 1, 0.4), 0.4, 2, derivatives);
  EXPECT_EQ(derivatives[4], 0.0);
  EXPECT_EQ(derivatives[5], 0.0);
  EXPECT_NEAR(derivatives[2], -3.0, 1e-13);
}

TEST(CubicSpanMatrix, IsThePowerFormOfTheBasisFunctions) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const auto knots = randomKnots(random, 3, 6);
    const double u = random.uniform(knots.front(), knots.back());
    const std::size_t span = findSpan(knots, 3, u);
    const CubicSpanMatrix matrix = cubicSpanMatrix(&knots[span - 2]);
    const double s = 2.0 * (u - knots[span]) / (knots[span + 1] - knots[span]) - 1.0;
    double values[4];
    basisFunctions(knots, 3, span, u, values);
    for (std::size_t j = 0; j < 4; ++j) {
      const double power = ((matrix[3][j] * s + matrix[2][j]) * s + matrix[1][j]) * s + matrix[0][j];
      EXPECT_NEAR(power, values[j], 1e-13);  // some tens of roundings of numbers up to 10
    }
  }
}

TEST(GrevilleAbscissae, ReproduceTheParameter) {
  Random random(4);
  for (int round = 0; round < 50; ++round) {
    const int degree = 1 + static_cast<int>(random.uniform(0.0, 5.0));
    const auto knots = randomKnots(random, degree, 6);
    const auto abscissae = grevilleAbscissae(knots, degree);
    const double u = random.uniform(knots.front(), knots.back());
    const std::size_t span = findSpan(knots, degree, u);
    double values[max_degree + 1];
    basisFunctions(knots, degree, span, u, values);
    double sum = 0.0;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(degree); ++j) {
      sum += values[j] * abscissae[span - static_cast<std::size_t>(degree) + j];
    }
    EXPECT_NEAR(sum, u, 1e-13);
  }
}

TEST(ClampedUniformKnots, HaveEqualSpans) {
  const auto knots = clampedUniformKnots(-1.0, 2.0, 9, 3);
  ASSERT_EQ(knots.size(), 13u);
  for (std::size_t i = 3; i < 9; ++i) EXPECT_NEAR(knots[i + 1] - knots[i], 0.5, 1e-15);
  EXPECT_NO_THROW(validateKnots(knots, 3, 9, "test"));
}

TEST(ClampedUniformKnots, RefuseBadInput) {
  expectInputError([] { clampedUniformKnots(1.0, 1.0, 9, 3); }, "last knot");
  expectInputError([] { clampedUniformKnots(0.0, NAN, 9, 3); }, "last knot");
  expectInputError([] { clampedUniformKnots(0.0, 1.0, 3, 3); }, "number of control points is 3");
  expectInputError([] { clampedUniformKnots(0.0, 1.0, 30, max_degree + 1); }, "control points");
}

TEST(ValidateKnots, NamesWhatIsWrong) {
  const std::vector<double> good = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  const auto changed = [&](std::size_t i, double value) {
    auto knots = good;
    knots[i] = value;
    return knots;
  };
  EXPECT_NO_THROW(validateKnots(good, 3, 6, "curve"));
  expectInputError([&] { validateKnots(changed(5, NAN), 3, 6, "curve"); }, "curve: knot 5 is nan, must be finite");
  expectInputError([&] { validateKnots(changed(5, 0.5), 3, 6, "curve"); }, "knot 5");
  expectInputError([&] { validateKnots(changed(0, -1.0), 3, 6, "curve"); }, "clamped");
  expectInputError([&] { validateKnots(changed(4, 0.0), 3, 6, "curve"); }, "knot");
  expectInputError([&] { validateKnots(changed(5, 3.0), 3, 6, "curve"); }, "knot");
  expectInputError([&] { validateKnots(good, 3, 7, "curve"); }, "number of knots is 10, must be 11");
  expectInputError([&] { validateKnots(good, 0, 6, "curve"); }, "degree");
  expectInputError([&] { validateKnots(good, 10, 6, "curve"); }, "degree");
  expectInputError([&] { validateKnots({}, 3, 0, "curve"); }, "number of control points");
}

}  // namespace
}  // namespace scan_to_path::nurbs
