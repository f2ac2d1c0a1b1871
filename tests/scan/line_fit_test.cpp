// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/line_fit.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "scan_to_path/scan/fit_scan.h"
#include "support/expect_input_error.h"
#include "support/profile_rows.h"

namespace scan_to_path::scan {
namespace {

using test::chamferedEnd;
using test::Profile;
using test::roof;
using test::rowsOf;
using test::shortWave;

void cutOut(SampleRows& rows, double from, double to) {
  for (RowPiece& piece : rows.pieces) {
    RowPiece kept;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (piece.x[i] > from && piece.x[i] < to) continue;
      kept.x.push_back(piece.x[i]);
      kept.y.push_back(piece.y[i]);
      kept.z.push_back(piece.z[i]);
      kept.index.push_back(piece.index[i]);
    }
    kept.row = piece.row;
    piece = kept;
  }
}

double largestError(const FittedLine& line, const Profile& z) {
  double largest = 0.0;
  for (int k = 0; k <= 500; ++k) {
    const Vector3 p = nurbs::pointAt(line.curve, line.begin + (line.end - line.begin) * k / 500);
    largest = std::max(largest, std::abs(p.z() - z(p.x())));
  }
  return largest;
}

class Parameterizations : public ::testing::TestWithParam<Parameterization> {};

TEST_P(Parameterizations, FollowASmoothRow) {
  LineFitOptions options;
  options.parameterization = GetParam();
  const FittedLines fitted = fitLines(rowsOf(shortWave), options);
  ASSERT_EQ(fitted.lines.size(), 5u);
  for (const FittedLine& line : fitted.lines) {
    EXPECT_LT(largestError(line, shortWave), 0.1e-6);
    EXPECT_NEAR(nurbs::pointAt(line.curve, line.begin).x(), 0.0, 1e-6);
    EXPECT_NEAR(nurbs::pointAt(line.curve, line.end).x(), 0.1, 60e-6);
    EXPECT_TRUE(line.begins_at_edge && line.ends_at_edge);
  }
  EXPECT_EQ(fitted.lines[1].row, 1);
  EXPECT_FALSE(fitted.lines[1].forward);
}

INSTANTIATE_TEST_SUITE_P(All, Parameterizations,
                         ::testing::Values(Parameterization::scan_coordinate, Parameterization::chord_length,
                                           Parameterization::centripetal),
                         [](const auto& info) { return std::string(enumName(info.param)); });

TEST(LineFit, EstimatesTheNoiseAlongTheBeam) {
  const double noise = 10e-6;
  const FittedLines fitted = fitLines(rowsOf(shortWave, noise), {});
  for (const FittedLine& line : fitted.lines) {
    // The estimate scatters by sigma / sqrt(2 n); factor 3.
    EXPECT_NEAR(line.sigma, noise, 3.0 * noise / std::sqrt(2.0 * static_cast<double>(line.samples)));
    EXPECT_LT(line.residual_rms, line.sigma);
  }
}

TEST(LineFit, KnownNoiseChoosesByMallows) {
  LineFitOptions options;
  options.control_points.noise = 10e-6;
  const FittedLines fitted = fitLines(rowsOf(shortWave, 10e-6), options);
  for (const FittedLine& line : fitted.lines) EXPECT_LT(largestError(line, shortWave), 5e-6);
}

TEST(LineFit, CurvesAreInTheCloudsFrame) {
  SampleRows rows = rowsOf(shortWave);
  const FittedLines here = fitLines(rows, {});
  rows.T_cloud_scan = geometry::makeFrame({1.0, 2.0, 3.0}, {0.3, 0.2, 0.1});
  const FittedLines there = fitLines(rows, {});
  for (std::size_t i = 0; i < here.lines.size(); ++i) {
    const Vector3 p = rows.T_cloud_scan * nurbs::pointAt(here.lines[i].curve, 0.05);
    EXPECT_LT((p - nurbs::pointAt(there.lines[i].curve, 0.05)).norm(), 1e-14);
  }
}

TEST(LineFit, ACornerSplitsTheLine) {
  const SampleRows rows = rowsOf(roof, 10e-6);
  const FittedLines fitted = fitLines(rows, {});
  ASSERT_EQ(fitted.lines.size(), 10u);
  EXPECT_TRUE(fitted.lines[0].begins_at_edge);
  EXPECT_FALSE(fitted.lines[0].ends_at_edge);
  EXPECT_FALSE(fitted.lines[1].begins_at_edge);
  // Beside the corner a few samples of the other side may have gone along: 150 um of it at slope 2 off.
  EXPECT_LT(largestError(fitted.lines[0], roof), 60e-6);
  LineFitOptions off;
  off.corner_angle = 3.0;
  EXPECT_GT(largestError(fitLines(rows, off).lines[0], roof), 20e-6);
}

/// Largest height of what is beside the corner, `length` from either end, off the fitted lines.
double largestErrorOfEnds(const SampleRows& rows, const Profile& z) {
  double largest = 0.0;
  for (const FittedLine& line : fitLines(rows, {}).lines) largest = std::max(largest, largestError(line, z));
  return largest;
}

TEST(LineFit, ACornerNearALinesEndSplitsIt) {
  // All shorter than the corner window of 1 mm.
  for (const double length : {0.2e-3, 0.3e-3, 0.5e-3, 0.95e-3}) {
    const Profile z = chamferedEnd(length);
    const SampleRows rows = rowsOf(z, 10e-6, 40);
    // At most two samples of the slope go along with the level, 100 um down, and the noise of a line's end is below 3
    // sigma.
    EXPECT_LT(largestErrorOfEnds(rows, z), 100e-6) << length;
    EXPECT_LT(largestErrorOfEnds(test::mirrored(rows), [&](double x) { return z(0.1 - x); }), 100e-6) << length;
  }
}

TEST(LineFit, SamplesBeyondACornerTooFewToFitAreCounted) {
  const SampleRows rows = rowsOf(chamferedEnd(0.25e-3), 2e-6);
  const FittedLines fitted = fitLines(rows, {});
  EXPECT_EQ(fitted.lines.size(), 5u);
  EXPECT_FALSE(fitted.lines[0].ends_at_edge);
  ASSERT_EQ(fitted.dropped.size(), 1u);
  EXPECT_EQ(fitted.dropped[0].reason, "too short to fit");
  EXPECT_NEAR(static_cast<double>(fitted.dropped[0].count), 5.0 * 5.0, 5.0);
  EXPECT_EQ(fitted.too_short.size(), fitted.dropped[0].count);
}

// Neither in a line nor a piece of its own, it is there all the same: here, what rises at the ends of the rows.
TEST(LineFit, SamplesTooFewToFitStandInTheWay) {
  const auto risingEnd = [](double x) { return -chamferedEnd(0.25e-3)(x); };
  FitOptions options;
  options.with_surface = false;
  const Obstacles obstacles = fitRows(rowsOf(risingEnd, 2e-6), options).obstacles;
  ASSERT_GE(obstacles.size(), 5U);
  float highest = 0.0F;
  for (const auto& p : obstacles) {
    EXPECT_GT(p.x(), 0.0996F);
    highest = std::max(highest, p.z());
  }
  EXPECT_NEAR(highest, 0.25e-3, 50e-6 + 6e-6);  // a spacing, and three sigma
  EXPECT_TRUE(fitRows(rowsOf([](double) { return 0.0; }, 2e-6), options).obstacles.empty());  // twin
}

TEST(LineFit, AGapLongerThanAKnotSpanSplits) {
  SampleRows rows = rowsOf([](double x) { return 0.0001 * std::sin(1500.0 * x); });  // needs spans below a millimetre
  cutOut(rows, 0.05, 0.0518);
  const FittedLines fitted = fitLines(rows, {});
  EXPECT_EQ(fitted.lines.size(), 10u);
  EXPECT_FALSE(fitted.lines[0].ends_at_edge);
}

TEST(LineFit, AShortDropOutDoesNotMoveTheLine) {
  SampleRows rows = rowsOf(shortWave);
  cutOut(rows, 0.05, 0.0505);
  const FittedLines fitted = fitLines(rows, {});
  ASSERT_EQ(fitted.lines.size(), 5u);
  EXPECT_LT(largestError(fitted.lines[0], shortWave), 1.2e-6);
}

TEST(LineFit, ShortPiecesAreCounted) {
  SampleRows rows = rowsOf(shortWave);
  rows.pieces.push_back(subPiece(rows.pieces[0], 0, 5));
  rows.pieces.back().row = 5;
  const FittedLines fitted = fitLines(rows, {});
  ASSERT_EQ(fitted.dropped.size(), 1u);
  EXPECT_EQ(fitted.dropped[0].reason, "too short to fit");
  EXPECT_EQ(fitted.dropped[0].count, 5u);
  rows.pieces.erase(rows.pieces.begin(), rows.pieces.begin() + 5);
  test::expectInputError([&] { fitLines(rows, {}); }, "at least 8");
}

}  // namespace
}  // namespace scan_to_path::scan
