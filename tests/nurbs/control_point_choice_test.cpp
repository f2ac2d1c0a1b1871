// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/control_point_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/expect_input_error.h"
#include "support/spline_lines.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;
using test::SampledLine;

std::vector<LineMoments> momentsOf(const std::vector<SampledLine>& lines) {
  std::vector<LineMoments> moments;
  for (const SampledLine& line : lines) moments.emplace_back(line.view());
  return moments;
}

/// Mean squared error in z against the S part, every seventh sample.
double meanSquaredError(const Curve& curve, const SampledLine& line) {
  const geometry::SPart part;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < line.u.size(); i += 7, ++count) {
    sum += std::pow(pointAt(curve, line.u[i]).z() - part.jet(line.x[i], line.y[i]).z, 2);
  }
  return sum / static_cast<double>(count);
}

double pooledRms(const std::vector<LineMoments>& moments, const std::vector<SampledLine>& lines,
                 const std::vector<int>& counts) {
  double sum = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i) sum += meanSquaredError(moments[i].fit(counts[i]).curve, lines[i]);
  return std::sqrt(sum / static_cast<double>(lines.size()));
}

double bestRms(const std::vector<LineMoments>& moments, const std::vector<SampledLine>& lines) {
  double best = std::numeric_limits<double>::infinity();
  for (int p = 8; p <= 40; ++p) {
    best = std::min(best, pooledRms(moments, lines, std::vector<int>(lines.size(), p)));
  }
  return best;
}

/// The bar for fitted rows: against the best over all counts, and in itself.
bool meetsTheBar(double rms, double best) { return rms <= 1.1 * best + 0.05e-6 && rms <= 1.5e-6; }

class ChooseControlPoints : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(ChooseControlPoints, IsAsGoodAsTheBestCountOnTheSPart) {
  const auto lines = test::sPartLines(4800, 10e-6, GetParam(), test::sPartRows());
  const auto moments = momentsOf(lines);
  const double best = bestRms(moments, lines);
  const double chosen = pooledRms(moments, lines, chooseControlPoints(moments, {}));
  RecordProperty("ratio", std::to_string(chosen / best));
  EXPECT_TRUE(meetsTheBar(chosen, best)) << chosen << " m, best " << best << " m";
  CurveFitOptions alone;
  alone.window = 0;
  const double single = pooledRms(moments, lines, chooseControlPoints(moments, alone));
  EXPECT_TRUE(meetsTheBar(single, best)) << single << " m, best " << best << " m";
  EXPECT_LT(chosen, single);
  CurveFitOptions mallows;
  mallows.noise = 10e-6;
  EXPECT_TRUE(meetsTheBar(pooledRms(moments, lines, chooseControlPoints(moments, mallows)), best));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ChooseControlPoints, ::testing::Range<std::uint64_t>(1, 6));

TEST(ChooseControlPointsBar, FailsForWrongCountsDoubledNoiseAndAWrongSign) {
  auto lines = test::sPartLines(4800, 10e-6, 1, test::sPartRows());
  const auto moments = momentsOf(lines);
  const double best = bestRms(moments, lines);
  EXPECT_FALSE(meetsTheBar(pooledRms(moments, lines, std::vector<int>(lines.size(), 14)), best));
  EXPECT_FALSE(meetsTheBar(pooledRms(moments, lines, std::vector<int>(lines.size(), 40)), best));
  const auto noisy = momentsOf(test::sPartLines(4800, 20e-6, 1, test::sPartRows()));
  EXPECT_FALSE(meetsTheBar(pooledRms(noisy, lines, chooseControlPoints(noisy, {})), best));
  for (double& z : lines[20].z) z = -z;
  const auto flipped = momentsOf(lines);
  EXPECT_FALSE(meetsTheBar(pooledRms(flipped, lines, chooseControlPoints(flipped, {})), best));
}

TEST(ControlPointChoice, DoesNotDependOnTheThreads) {
  const auto moments = momentsOf(test::sPartLines(1200, 10e-6, 3, test::sPartRows()));
  const auto one = chooseControlPoints(moments, {}, 1);
  EXPECT_EQ(one, chooseControlPoints(moments, {}, 2));
  EXPECT_EQ(one, chooseControlPoints(moments, {}, 5));
}

TEST(ControlPointChoice, IsTheSameFromBothEndsOfTheLines) {
  auto lines = test::sPartLines(2400, 10e-6, 4, test::sPartRows());
  const auto forward = chooseControlPoints(momentsOf(lines), {});
  for (SampledLine& line : lines) {
    for (double& u : line.u) u = 0.24 - u;
  }
  EXPECT_EQ(forward, chooseControlPoints(momentsOf(lines), {}));
}

TEST(ControlPointChoice, PoolsLinesOfDifferentLengthAtTheSameKnotSpacing) {
  std::vector<SampledLine> lines = test::sPartLines(4800, 10e-6, 5, test::sPartRows());
  for (std::size_t i = 0; i < lines.size(); i += 2) {
    for (auto* array : {&lines[i].u, &lines[i].x, &lines[i].y, &lines[i].z}) array->resize(2400);
  }
  const auto moments = momentsOf(lines);
  const auto counts = chooseControlPoints(moments, {});
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double span = (moments[i].last() - moments[i].first()) / (counts[i] - 3);
    EXPECT_GT(span, 0.008) << i;  // the best spacing on the S part is 0.24 m / 16
    EXPECT_LT(span, 0.020) << i;
  }
}

TEST(ControlPointChoice, LinesWithoutAnAllowedCountGetNone) {
  auto lines = test::sPartLines(600, 10e-6, 6, {0.01, 0.02, 0.03});
  SampledLine two;
  two.add(0.0, 0.0, 0.04, 0.0);
  two.add(0.1, 0.1, 0.04, 0.0);
  lines.push_back(two);
  const auto counts = chooseControlPoints(momentsOf(lines), {});
  EXPECT_EQ(counts[3], 0);
  EXPECT_GT(counts[2], 8);
  EXPECT_TRUE(chooseControlPoints({}, {}).empty());
}

TEST(ControlPointChoice, AStubDoesNotChangeItsNeighbours) {
  auto lines = test::sPartLines(2400, 10e-6, 8, test::sPartRows());
  CurveFitOptions options;
  options.window = 1;
  const auto alone = chooseControlPoints(momentsOf({lines[20]}), options);
  SampledLine stub = lines[21];
  for (auto* array : {&stub.u, &stub.x, &stub.y, &stub.z}) array->resize(20);
  EXPECT_EQ(chooseControlPoints(momentsOf({stub, lines[20], stub}), options)[1], alone[0]);
}

TEST(ControlPointChoice, StraightLinesGetFewControlPoints) {
  Random random(7);
  std::vector<SampledLine> lines(9);
  for (SampledLine& line : lines) {
    for (int i = 0; i < 3000; ++i) line.add(i * 1e-4, i * 1e-4, 0.0, 1e-5 * random.gaussian());
  }
  for (const int count : chooseControlPoints(momentsOf(lines), {})) EXPECT_LE(count, 8);
}

TEST(ControlPointChoice, RefusesOptionsOutOfRange) {
  CurveFitOptions options;
  options.window = -1;
  expectInputError([&] { chooseControlPoints({}, options); }, "window");
  options = {};
  options.noise = -1e-6;
  expectInputError([&] { chooseControlPoints({}, options); }, "noise");
}

}  // namespace
}  // namespace scan_to_path::nurbs
