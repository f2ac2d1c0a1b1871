// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/between_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace scan_to_path::scan {
namespace {

constexpr double pitch = 0.004;

/// Exact straight lines along x at the heights that `height` has over y.
FittedScan rowsOver(const std::function<double(double)>& height, int rows = 41) {
  FittedScan scan;
  scan.pitch = pitch;
  for (int r = 0; r < rows; ++r) {
    FittedLine line;
    line.row = r;
    line.curve.knots = {0.0, 0.0, 0.0, 0.0, 0.1, 0.1, 0.1, 0.1};
    const double y = pitch * r;
    for (int k = 0; k < 4; ++k) line.curve.control_points.emplace_back(0.1 * k / 3.0, y, height(y));
    line.end = 0.1;
    scan.lines.push_back(line);
  }
  return scan;
}

TEST(BetweenRows, ACubicIsKnown) {
  const BetweenRows between =
      estimateBetweenRows(rowsOver([](double y) { return y + 5.0 * y * y - 30.0 * y * y * y; }));
  EXPECT_GE(between.points, 37U * 99U);
  EXPECT_LT(between.largest, 1e-12);  // rounding: 1e-16 of heights below 0.3 m, times weights
}

TEST(BetweenRows, AWaveIsOffByTheCubicsError) {
  const double wave = 2.0 * M_PI / 0.05;
  const double amplitude = 1e-3;
  const BetweenRows between = estimateBetweenRows(rowsOver([&](double y) { return amplitude * std::sin(wave * y); }));
  // 9/64 of the fourth derivative times h^4 / 6 at the crests; (wave h)^2 = 1/4 of it and the slope take a part.
  const double expected = 9.0 / 64.0 * amplitude * std::pow(wave * pitch, 4) / 6.0;
  EXPECT_LT(between.rms, 1.5 * expected);
  EXPECT_GT(between.rms, 0.4 * expected);
}

TEST(BetweenRows, ACreaseFallsWithTheFirstOrderAndAStepNotAtAll) {
  const double middle = 20 * pitch;
  const double bend = 0.1;
  const BetweenRows crease = estimateBetweenRows(rowsOver([&](double y) { return bend * std::abs(y - middle); }));
  // On the crease the cubic through +-h and +-2h is off by 2/3 bend h, half way between rows by 3/8 of it.
  EXPECT_NEAR(crease.largest, 0.6124 * 2.0 / 3.0 * bend * pitch, 0.02 * bend * pitch);
  EXPECT_GT(crease.largest, 3.0 / 8.0 * bend * pitch);
  const double height = 0.001;
  const BetweenRows step = estimateBetweenRows(rowsOver([&](double y) { return y < middle - 0.001 ? 0.0 : height; }));
  EXPECT_GT(step.largest, 0.4 * height);
}

TEST(BetweenRows, OneRowOffIsSeen) {  // the twin of ACubicIsKnown
  FittedScan scan = rowsOver([](double y) { return y; });
  for (Vector3& p : scan.lines[17].curve.control_points) p.z() += 1e-4;
  EXPECT_GT(estimateBetweenRows(scan).largest, 2e-5);
}

TEST(BetweenRows, FewerThanFiveRowsSayNothing) {
  const BetweenRows between = estimateBetweenRows(rowsOver([](double y) { return y; }, 4));
  EXPECT_EQ(between.points, 0U);
  EXPECT_EQ(between.rms, 0.0);
  EXPECT_EQ(between.share, 0.0);
  EXPECT_EQ(estimateBetweenRows(rowsOver([](double y) { return y; }, 5)).share, 1.0);
}

// Rows `first` to 40 go on for half their length again: fewer than five of them say nothing about that part.
TEST(BetweenRows, SayWhichShareTheyCover) {
  const auto shareWithTongue = [](int first) {
    FittedScan scan = rowsOver([](double y) { return y; });
    for (int r = first; r < 41; ++r) {
      FittedLine line = scan.lines[static_cast<std::size_t>(r)];
      for (Vector3& p : line.curve.control_points) p.x() = 0.1 + 0.5 * p.x();
      scan.lines.push_back(line);
    }
    std::stable_sort(scan.lines.begin(), scan.lines.end(), [](const auto& a, const auto& b) { return a.row < b.row; });
    return estimateBetweenRows(scan).share;
  };
  EXPECT_NEAR(shareWithTongue(37), 41.0 / (41.0 + 4 * 0.5), 1e-3);  // points lie a millimetre apart on 0.1 m
  EXPECT_EQ(shareWithTongue(36), 1.0);
}

}  // namespace
}  // namespace scan_to_path::scan
