// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace scan_to_path {
namespace {

constexpr int samples = 200000;

TEST(Random, FirstValuesStayTheSameForEver) {
  // From a second implementation in another language: outputs of every emulated scan hang on them.
  Random random(1);
  EXPECT_EQ(random.bits(), 5226295891941712017U);
  EXPECT_EQ(random.bits(), 5547022123706608281U);
  Random stream(1, 2);
  EXPECT_EQ(stream.bits(), 5845468077739584681U);
  Random gaussian(3);
  EXPECT_DOUBLE_EQ(gaussian.gaussian(), -0.5936390834802286);
}

TEST(Random, SameSeedSameNumbers) {
  Random a(7, 3);
  Random b(7, 3);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(a.bits(), b.bits());
}

TEST(Random, UniformHasItsMomentsAndRange) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < samples; ++i) {
      const double x = random.uniform();
      ASSERT_GE(x, 0.0);
      ASSERT_LT(x, 1.0);
      sum += x;
      squares += x * x;
    }
    // Standard errors sqrt(1 / 12 n) and sqrt(4 / 45 n), times 3.
    EXPECT_NEAR(sum / samples, 0.5, 3 * std::sqrt(1.0 / 12 / samples));
    EXPECT_NEAR(squares / samples, 1.0 / 3, 3 * std::sqrt(4.0 / 45 / samples));
  }
}

TEST(Random, UniformBetweenBoundsStaysThere) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(-3.0, 5.0);
    ASSERT_GE(x, -3.0);
    ASSERT_LT(x, 5.0);
  }
}

TEST(Random, GaussianHasItsMoments) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    std::array<double, 4> moment = {};
    for (int i = 0; i < samples; ++i) {
      const double x = random.gaussian();
      for (std::size_t k = 0; k < 4; ++k) moment[k] += std::pow(x, static_cast<double>(k + 1)) / samples;
    }
    // The variances of x, x^2, x^3 and x^4 are 1, 2, 15 and 96.
    EXPECT_NEAR(moment[0], 0.0, 3 * std::sqrt(1.0 / samples));
    EXPECT_NEAR(moment[1], 1.0, 3 * std::sqrt(2.0 / samples));
    EXPECT_NEAR(moment[2], 0.0, 3 * std::sqrt(15.0 / samples));
    EXPECT_NEAR(moment[3], 3.0, 3 * std::sqrt(96.0 / samples));
  }
}

/// Correlation of two generators' uniform numbers.
double correlation(Random a, Random b) {
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) sum += (a.uniform() - 0.5) * (b.uniform() - 0.5);
  return 12 * sum / samples;
}

TEST(Random, StreamsAndSeedsAreIndependent) {
  const double limit = 3 / std::sqrt(samples);
  for (std::uint64_t k = 0; k < 5; ++k) {
    EXPECT_LT(std::abs(correlation(Random(1, k), Random(1, k + 1))), limit);
    EXPECT_LT(std::abs(correlation(Random(k, 0), Random(k + 1, 0))), limit);
    // Neighbours on the diagonal must not collide either.
    EXPECT_LT(std::abs(correlation(Random(k, k + 1), Random(k + 1, k))), limit);
  }
  EXPECT_GT(correlation(Random(1, 1), Random(1, 1)), 0.9);
}

TEST(Random, SuccessiveNumbersAreUncorrelated) {
  Random late(1);
  late.uniform();
  EXPECT_LT(std::abs(correlation(Random(1), late)), 3 / std::sqrt(samples));
}

}  // namespace
}  // namespace scan_to_path
