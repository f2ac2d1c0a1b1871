// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/corners.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/profile_rows.h"

namespace scan_to_path::scan {
namespace {

using test::Profile;
using test::rowsOf;
using test::shortWave;

TEST(Corners, AreFoundWhereTwoSlopesMeet) {
  const SampleRows rows = rowsOf(test::roof, 10e-6);
  const auto corners = findCorners(rows.pieces[0], {});
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_NEAR(rows.pieces[0].x[corners[0].index], 0.04, 150e-6);
  EXPECT_NEAR(corners[0].angle, std::atan(1.0) * 2.0, 0.05);
  LineFitOptions off;
  off.corner_angle = 3.0;
  EXPECT_TRUE(findCorners(rows.pieces[0], off).empty());
}

TEST(Corners, AreFoundNearALinesEnd) {
  // All shorter than the corner window of 1 mm; the shortest leaves four samples beyond the corner.
  for (const double length : {0.2e-3, 0.3e-3, 0.5e-3, 0.95e-3}) {
    const SampleRows rows = rowsOf(test::chamferedEnd(length), 10e-6, 40);
    for (const RowPiece& piece : rows.pieces) {
      const auto corners = findCorners(piece, {});
      ASSERT_EQ(corners.size(), 1u) << length;
      EXPECT_NEAR(piece.x[corners[0].index], 0.1 - length, 110e-6);  // two samples
    }
    for (const RowPiece& piece : test::mirrored(rows).pieces) EXPECT_EQ(findCorners(piece, {}).size(), 1u) << length;
  }
}

TEST(Corners, AreNoneAtNoisyAndRoundEnds) {
  // Four samples of 10 um noise, 50 um apart, have a slope that scatters by 0.09: not one of 2000 ends may show.
  std::size_t corners = 0;
  for (const RowPiece& piece : rowsOf(shortWave, 10e-6, 1000).pieces) corners += findCorners(piece, {}).size();
  EXPECT_EQ(corners, 0u);
  // A round of 2 mm and of 4 mm radius towards the end, down to a slope of 45 degrees.
  for (const double radius : {2e-3, 4e-3}) {
    const Profile round = [radius](double x) {
      const double s = x - (0.1 - radius * std::sqrt(0.5));
      return s > 0.0 ? std::sqrt(radius * radius - s * s) - radius : 0.0;
    };
    for (const RowPiece& piece : rowsOf(round, 2e-6, 20).pieces) corners += findCorners(piece, {}).size();
  }
  EXPECT_EQ(corners, 0u);
}

TEST(Corners, AreNoneOfRoundsAndNoise) {
  // A round of 4 mm radius between two slopes of 45 degrees turns by 0.25 rad within a window of 1 mm.
  const Profile round = [](double x) {
    const double radius = 0.004;
    const double s = std::abs(x - 0.05);
    const double half = radius * std::sqrt(0.5);
    return s < half ? std::sqrt(radius * radius - s * s) : half - (s - half);
  };
  EXPECT_TRUE(findCorners(rowsOf(round).pieces[0], {}).empty());
  for (const double spacing : {10e-6, 50e-6, 200e-6}) {
    const SampleRows noisy = rowsOf(shortWave, 10e-6, 3, spacing);
    for (const RowPiece& piece : noisy.pieces) EXPECT_TRUE(findCorners(piece, {}).empty());
  }
}

}  // namespace
}  // namespace scan_to_path::scan
