// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/line_moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/dense_spline_fit.h"
#include "support/expect_input_error.h"
#include "support/spline_lines.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;
using test::SampledLine;

SampledLine randomLine(Random& random, int samples) {
  SampledLine line;
  double u = -0.3;
  for (int i = 0; i < samples; ++i) {
    u += random.uniform(0.5e-4, 1.5e-4);
    line.add(u, 1.0 + u, -0.5 + 0.1 * u, 0.02 * std::sin(30.0 * u) + 1e-5 * random.gaussian());
  }
  return line;
}

TEST(LineMoments, FitIsTheLeastSquaresCurveOnItsKnots) {
  Random random(1);
  for (int round = 0; round < 10; ++round) {
    const SampledLine line = randomLine(random, 300 + 80 * round);
    const LineMoments moments(line.view());
    for (int p = 4; p <= 60; p += 7) {
      const CurveFit fit = moments.fit(p);
      ASSERT_TRUE(fit.fitted) << p;
      EXPECT_NO_THROW(validate(fit.curve));
      ASSERT_EQ(fit.curve.control_points.size(), static_cast<std::size_t>(p));
      const auto oracle = test::denseSplineFit(line.view(), fit.curve.knots);
      // Samples are up to 1 m from the line's origin times 1e-16 times the condition of the normal equations, 1e4.
      for (int i = 0; i < p; ++i) {
        const Vector3 expected = oracle.control_points.row(i).transpose();
        EXPECT_LT((fit.curve.control_points[static_cast<std::size_t>(i)] - expected).norm(), 1e-11);
      }
      EXPECT_NEAR(moments.rss(p), oracle.rss, 1e-7 * oracle.rss);
      EXPECT_DOUBLE_EQ(fit.rms, std::sqrt(moments.rss(p) / static_cast<double>(moments.samples())));
      EXPECT_GT(fit.sigma, fit.rms);
    }
  }
}

TEST(LineMoments, KnotsAreNearlyUniformAndTheSameFromBothEnds) {
  Random random(2);
  const SampledLine line = randomLine(random, 4800);
  const LineMoments moments(line.view());
  for (int p = 4; p <= 131; ++p) {
    const auto knots = moments.fit(p).curve.knots;
    ASSERT_EQ(knots.size(), static_cast<std::size_t>(p) + 4) << p;
    EXPECT_EQ(knots.front(), line.u.front());
    EXPECT_EQ(knots.back(), line.u.back());
    const double span = (moments.last() - moments.first()) / (p - 3);
    // Rounding moves an end by half a block: an eighth of a span while blocks are a quarter of it, half at the limit.
    const double allowed = p <= 67 ? 0.126 : 0.251;
    for (std::size_t i = 3; i < knots.size() - 3; ++i) {
      const double uniform = moments.first() + span * static_cast<double>(i - 3);
      EXPECT_LE(std::abs(knots[i] - uniform), allowed * span) << p;
      const double mirrored = moments.first() + moments.last() - knots[knots.size() - 1 - i];
      EXPECT_NEAR(knots[i], mirrored, 1e-15);
    }
  }
}

TEST(LineMoments, NoiseFreeResidualsStayPositiveAndFall) {
  Random random(3);
  const SampledLine line = test::sPartLine(0.05, 4800, 0.0, random);
  const LineMoments moments(line.view());
  double before = 1.0;
  for (int p = 4; p <= 128; p *= 2) {
    const double rms = std::sqrt(moments.rss(p) / 4800.0);
    EXPECT_GT(rms, 0.0);
    EXPECT_LT(rms, 0.5 * before);
    before = rms;
  }
  // 1.6e-3 h^4 |f''''| of a cubic spline with h = 0.24 m / 125: 2e-10 m; the documented floor is 2e-11 m.
  EXPECT_LT(before, 3e-10);
}

TEST(LineMoments, AGapAllowsOnlySpansThatHoldData) {
  Random random(4);
  SampledLine line;
  for (int i = 0; i < 2000; ++i) {
    const double u = i * 1e-4;
    if (u < 0.1 || u > 0.12) line.add(u, u, 0.0, 1e-5 * random.gaussian());
  }
  const LineMoments moments(line.view());
  EXPECT_NEAR(moments.largestGap(), 0.0201, 2e-4);
  EXPECT_FALSE(std::isnan(moments.rss(8)));
  EXPECT_TRUE(std::isnan(moments.rss(60)));
  const CurveFit refused = moments.fit(60);
  EXPECT_FALSE(refused.fitted);
  EXPECT_NEAR(refused.largest_gap, moments.largestGap(), 0.0);
}

TEST(LineMoments, RefusesCountsThatTheSamplesDoNotDetermine) {
  Random random(5);
  const SampledLine line = randomLine(random, 30);
  const LineMoments moments(line.view());
  EXPECT_TRUE(std::isnan(moments.rss(3)));
  EXPECT_TRUE(std::isnan(moments.rss(-1)));
  EXPECT_FALSE(std::isnan(moments.rss(4)));
  EXPECT_TRUE(std::isnan(moments.rss(16)));
  EXPECT_FALSE(moments.fit(1000000).fitted);
}

TEST(LineMoments, ShortLines) {
  SampledLine line;
  line.add(0.0, 0.0, 0.0, 0.0);
  expectInputError([&] { LineMoments{line.view()}; }, "parameter range");
  line.add(1.0, 1.0, 0.0, 0.0);
  EXPECT_TRUE(std::isnan(LineMoments(line.view()).rss(4)));
  EXPECT_GE(LineMoments(line.view()).usefulControlPoints(), 4);
}

TEST(LineMoments, UnsortedSamplesGiveTheSameFit) {
  Random random(6);
  const SampledLine line = randomLine(random, 500);
  SampledLine shuffled;
  for (std::size_t i = 0; i < 500; ++i) {
    const std::size_t j = i * 237 % 500;
    shuffled.add(line.u[j], line.x[j], line.y[j], line.z[j]);
  }
  const LineMoments a(line.view());
  const LineMoments b(shuffled.view());
  EXPECT_EQ(a.rss(12), b.rss(12));
  EXPECT_EQ(a.largestGap(), b.largestGap());
}

TEST(LineMoments, MovingTheSamplesRigidlyMovesTheFit) {
  Random random(7);
  const SampledLine line = randomLine(random, 800);
  const geometry::Frame T = geometry::makeFrame(Vector3(0.3, -0.8, 0.4), Vector3(0.4, -1.0, 2.0));
  SampledLine moved;
  for (std::size_t i = 0; i < line.u.size(); ++i) {
    const Vector3 p = T * Vector3(line.x[i], line.y[i], line.z[i]);
    moved.add(line.u[i], p.x(), p.y(), p.z());
  }
  const CurveFit a = LineMoments(line.view()).fit(14);
  const CurveFit b = LineMoments(moved.view()).fit(14);
  EXPECT_NEAR(a.rms, b.rms, 1e-6 * a.rms);
  for (std::size_t i = 0; i < 14; ++i) {
    EXPECT_LT((T * a.curve.control_points[i] - b.curve.control_points[i]).norm(), 1e-12);
  }
}

TEST(LineMoments, UsefulCountFollowsTheStructure) {
  Random random(8);
  const auto useful = [&](double waves) {
    SampledLine line;
    for (int i = 0; i < 4800; ++i) {
      const double u = i / 4800.0;
      line.add(u, u, 0.0, 1e-3 * std::sin(2.0 * M_PI * waves * u) + 1e-5 * random.gaussian());
    }
    return LineMoments(line.view()).usefulControlPoints();
  };
  // A wave of 100 sigma takes some 8 spans. The limit is three times a power of two of piecewise cubics.
  EXPECT_GE(useful(1), 10);
  EXPECT_LE(useful(1), 27);
  EXPECT_GE(useful(8), 80);
}

TEST(LineMoments, RefusesNumbersThatAreNone) {
  Random random(9);
  for (auto SampledLine::*member : {&SampledLine::u, &SampledLine::x, &SampledLine::y, &SampledLine::z}) {
    SampledLine line = randomLine(random, 100);
    (line.*member)[41] = std::numeric_limits<double>::quiet_NaN();
    expectInputError([&] { LineMoments{line.view()}; }, "of sample 41");
    (line.*member)[41] = std::numeric_limits<double>::infinity();
    expectInputError([&] { LineMoments{line.view()}; }, "of sample 41");
  }
  expectInputError([] { LineMoments{LineSamples{}}; }, "number of samples is 0");
}

}  // namespace
}  // namespace scan_to_path::nurbs
