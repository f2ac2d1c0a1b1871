// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/spikes.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scan_to_path/common/random.h"

namespace scan_to_path::scan {
namespace {

/// Samples at uneven distances of 20 to 80 um with the height z(x).
template <class Height>
RowPiece pieceOf(Height&& z, std::size_t count = 400) {
  Random random(9);
  RowPiece piece;
  double x = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    piece.x.push_back(x);
    piece.z.push_back(z(x));
    x += random.uniform(20e-6, 80e-6);
  }
  piece.y.assign(count, 0.0);
  piece.index.assign(count, 0);
  return piece;
}

std::vector<std::size_t> spikesOf(const RowPiece& piece, double limit) {
  const std::vector<char> marks = findSpikes(piece, neighbourResiduals(piece), limit);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0) found.push_back(i);
  }
  return found;
}

TEST(NeighbourResiduals, AreBlindToSlopeAtAnySpacing) {
  for (const double residual : neighbourResiduals(pieceOf([](double x) { return 2.0 + 1.7 * x; }))) {
    EXPECT_LT(std::abs(residual), 5e-15);  // some roundings of 2 m
  }
}

TEST(NeighbourResiduals, ASpikeShowsItsHeightAtItsPlaceAndNowhereElse) {
  for (const std::size_t place : {0U, 3U, 4U, 5U, 200U, 395U, 399U}) {
    RowPiece piece = pieceOf([](double x) { return 0.4 * x; });
    piece.z[place] += 0.001;
    const auto residuals = neighbourResiduals(piece);
    EXPECT_NEAR(residuals[place], 0.001, 1e-15) << place;
    for (std::size_t i = 5; i < 395; ++i) {
      if (i == place) continue;  // a spike is in one of five chords only, and the median does not care
      EXPECT_LT(std::abs(residuals[i]), 1e-15) << place << " " << i;
    }
  }
}

TEST(NeighbourResiduals, OfShortPiecesAreOneSidedOrZero) {
  for (std::size_t count = 0; count <= 12; ++count) {
    const auto residuals = neighbourResiduals(pieceOf([](double x) { return 0.3 * x; }, count));
    EXPECT_EQ(residuals.size(), count);
    for (const double residual : residuals) EXPECT_LT(std::abs(residual), 1e-15) << count;
  }
}

TEST(NeighbourResiduals, SamplesAtOnePlaceDoNotDivideByZero) {
  RowPiece piece = pieceOf([](double) { return 0.5; });
  for (std::size_t i = 100; i < 130; ++i) piece.x[i] = piece.x[100];
  for (const double residual : neighbourResiduals(piece)) EXPECT_EQ(residual, 0.0);
}

TEST(MedianAbsoluteResidual, IsThatOfInnerSamplesOnly) {
  std::vector<double> piece(21, 3.0);
  for (std::size_t i = 0; i < 5; ++i) piece[i] = piece[20 - i] = 100.0;  // ends
  for (std::size_t i = 5; i < 9; ++i) piece[i] = -7.0;
  EXPECT_EQ(medianAbsoluteResidual({{piece}, {}, {{}}}), 3.0);
  EXPECT_EQ(medianAbsoluteResidual({{std::vector<double>(10, 1.0)}}), 0.0);
  EXPECT_EQ(medianAbsoluteResidual({}), 0.0);
}

TEST(MedianAbsoluteResidual, OfWhiteNoiseTellsItsSigma) {
  Random random(4);
  const double sigma = 1e-5;
  std::vector<PieceResiduals> residuals;
  for (int row = 0; row < 30; ++row) {
    residuals.push_back({neighbourResiduals(pieceOf([&](double) { return sigma * random.gaussian(); }, 5000))});
  }
  // The median of five chord heights has a sigma of about sqrt(0.5 * 0.287) of a sample's, so the residual 1.07; with
  // uneven spacing chords are a little noisier.
  EXPECT_NEAR(1.4826 * medianAbsoluteResidual(residuals) / sigma, 1.08, 0.03);
}

TEST(FindSpikes, MarksSpikesInsideAtTheEndsAndSideBySide) {
  RowPiece piece = pieceOf([](double x) { return 0.02 * std::sin(25.0 * x); });
  for (const std::size_t i : {0U, 7U, 100U, 101U, 250U, 399U}) piece.z[i] += i % 2 == 0 ? 0.0005 : -0.0004;
  EXPECT_THAT(spikesOf(piece, 3e-5), testing::ElementsAre(0, 7, 100, 101, 250, 399));
  EXPECT_TRUE(spikesOf(piece, 0.01).empty());  // twin: a limit that lets them pass
}

TEST(FindSpikes, CornersAreConfirmedFromOneSide) {
  const RowPiece roof = pieceOf([](double x) { return -1.2 * std::abs(x - 0.01); });
  EXPECT_TRUE(spikesOf(roof, 1e-6).empty());
  const auto residuals = neighbourResiduals(roof);  // though the chords there do not fit
  EXPECT_GT(*std::max_element(residuals.begin(), residuals.end()), 1e-5);
}

}  // namespace
}  // namespace scan_to_path::scan
