// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/resample.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scan_to_path/nurbs/line_moments.h"
#include "support/expect_input_error.h"

namespace scan_to_path::scan {
namespace {

/// A line through z = a sin(60 x), x from 0 to 0.1 m.
FittedLine waveLine(double amplitude) {
  std::vector<double> x, y, z;
  for (int i = 0; i <= 2000; ++i) {
    x.push_back(50e-6 * i);
    y.push_back(0.0);
    z.push_back(amplitude * std::sin(60.0 * x.back()));
  }
  FittedLine line;
  line.curve = nurbs::LineMoments({x.data(), x.data(), y.data(), z.data(), x.size()}).fit(40).curve;
  line.begin = line.curve.first();
  line.end = line.curve.last();
  return line;
}

std::vector<double> distances(const FittedLine& line, const std::vector<double>& parameters) {
  std::vector<double> result;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    result.push_back(
        (nurbs::pointAt(line.curve, parameters[i]) - nurbs::pointAt(line.curve, parameters[i - 1])).norm());
  }
  return result;
}

double largestChordError(const FittedLine& line, const std::vector<double>& parameters) {
  double largest = 0.0;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    const Vector3 a = nurbs::pointAt(line.curve, parameters[i - 1]);
    const Vector3 chord = (nurbs::pointAt(line.curve, parameters[i]) - a).normalized();
    for (int k = 1; k < 8; ++k) {
      const double u = parameters[i - 1] + (parameters[i] - parameters[i - 1]) * k / 8;
      largest = std::max(largest, chord.cross(nurbs::pointAt(line.curve, u) - a).norm());
    }
  }
  return largest;
}

TEST(Resample, EqualDistancesWithBothEnds) {
  const FittedLine line = waveLine(0.01);
  ResampleOptions options;
  for (const double spacing : {0.0001, 0.0007, 0.003, 0.05}) {
    options.spacing = spacing;
    const auto parameters = resampleParameters(line, options);
    EXPECT_EQ(parameters.front(), line.begin);
    EXPECT_EQ(parameters.back(), line.end);
    EXPECT_TRUE(std::is_sorted(parameters.begin(), parameters.end()));
    const auto steps = distances(line, parameters);
    for (const double step : steps) {
      EXPECT_LE(step, spacing * 1.0001);
      if (spacing < 0.001) {
        EXPECT_NEAR(step, steps[0], 1e-4 * spacing);  // chords of short steps are arcs to 1e-5
      }
    }
  }
}

TEST(Resample, AStraightLineIsDividedEvenly) {
  ResampleOptions options;
  options.spacing = 0.03;
  const auto parameters = resampleParameters(waveLine(0.0), options);
  ASSERT_EQ(parameters.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(parameters[k], 0.025 * static_cast<double>(k), 1e-12);
  options.spacing = 0.025;  // divides it exactly
  EXPECT_EQ(resampleParameters(waveLine(0.0), options).size(), 5u);
}

TEST(Resample, ChordErrorHolds) {
  const FittedLine line = waveLine(0.01);
  ResampleOptions options;
  options.spacing = 0.01;
  options.chord_error = 1e-6;
  const auto parameters = resampleParameters(line, options);
  EXPECT_LE(largestChordError(line, parameters), 1e-6);
  EXPECT_GE(largestChordError(line, parameters), 0.8e-6);  // and no finer than needed
  for (const double step : distances(line, parameters)) EXPECT_LE(step, 0.01);
  options.chord_error = 0.0;  // twin
  EXPECT_GT(largestChordError(line, resampleParameters(line, options)), 1e-5);
}

TEST(Resample, RefusesEmptyLinesAndBadSpacing) {
  FittedLine line = waveLine(0.01);
  ResampleOptions options;
  options.spacing = 0.0;
  test::expectInputError([&] { resampleParameters(line, options); }, "resample.spacing is 0 m");
  line.end = line.begin;
  test::expectInputError([&] { resampleParameters(line, {}); }, "after its begin");
}

}  // namespace
}  // namespace scan_to_path::scan
