// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/outline.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scan_to_path/common/random.h"

namespace scan_to_path::scan {
namespace {

using Range = std::pair<double, double>;

/// Rows at y = row, given as the x ranges of their pieces.
SampleRows rowsOf(const std::vector<std::vector<Range>>& ranges) {
  SampleRows rows;
  for (std::size_t row = 0; row < ranges.size(); ++row) {
    for (const auto& [begin, end] : ranges[row]) {
      RowPiece piece;
      piece.row = static_cast<int>(row);
      piece.x = {begin, 0.5 * (begin + end), end};
      piece.y.assign(3, static_cast<double>(row));
      piece.z.assign(3, 0.0);
      piece.index.assign(3, 0);
      rows.pieces.push_back(piece);
    }
  }
  return rows;
}

double area(const std::vector<Eigen::Vector2d>& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& p = polygon[i];
    const auto& q = polygon[(i + 1) % polygon.size()];
    sum += 0.5 * (p.x() * q.y() - q.x() * p.y());
  }
  return sum;
}

/// Winding number by angles: an independent oracle.
bool insideByAngles(const Outline& outline, double x, double y) {
  double turn = 0.0;
  for (const auto& polygon : outline.polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d p = polygon[i] - Eigen::Vector2d(x, y);
      const Eigen::Vector2d q = polygon[(i + 1) % polygon.size()] - Eigen::Vector2d(x, y);
      turn += std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
    }
  }
  return std::abs(turn) > 3.0;
}

TEST(Outline, EndsWhereRowsAreMissing) {
  SampleRows rows = rowsOf({{{0, 10}}, {{0, 10}}, {{0, 10}}, {{0, 10}}, {{0, 10}}, {{0, 10}}});
  EXPECT_EQ(traceOutline(rows).polygons.size(), 1U);
  for (auto& piece : rows.pieces) {
    if (piece.row >= 3) piece.y.assign(3, piece.row + 2.0);  // two rows between 2 and 3 are missing
  }
  const Outline outline = traceOutline(rows);
  ASSERT_EQ(outline.polygons.size(), 2U);
  EXPECT_TRUE(insideByAngles(outline, 5.0, 1.5));
  EXPECT_FALSE(insideByAngles(outline, 5.0, 3.5));
  EXPECT_TRUE(insideByAngles(outline, 5.0, 6.5));
}

TEST(Outline, OneQuadrilateral) {
  const Outline outline = traceOutline(rowsOf({{{0, 10}}, {{1, 9}}, {{2, 8}}}));
  ASSERT_EQ(outline.polygons.size(), 1u);
  EXPECT_DOUBLE_EQ(area(outline.polygons[0]), 9.0 + 7.0);
}

TEST(Outline, AHoleIsClockwiseAndReachesTheRowsAroundIt) {
  const Outline outline =
      traceOutline(rowsOf({{{0, 10}}, {{0, 10}}, {{0, 4}, {6, 10}}, {{0, 4}, {6, 10}}, {{0, 10}}, {{0, 10}}}));
  ASSERT_EQ(outline.polygons.size(), 2u);
  EXPECT_DOUBLE_EQ(area(outline.polygons[0]), 50.0);
  EXPECT_DOUBLE_EQ(area(outline.polygons[1]), -6.0);
  const OutlineTest test(outline);
  EXPECT_TRUE(test.inside(5.0, 0.9));
  EXPECT_FALSE(test.inside(5.0, 1.1));
  EXPECT_FALSE(test.inside(5.0, 2.5));
  EXPECT_TRUE(test.inside(3.9, 2.5));
}

TEST(Outline, SeparateIslands) {
  const Outline outline = traceOutline(rowsOf({{{0, 3}, {5, 9}}, {{0, 3}, {5, 9}}, {}, {{0, 9}}, {{0, 9}}}));
  ASSERT_EQ(outline.polygons.size(), 3u);
  EXPECT_FALSE(OutlineTest(outline).inside(1.0, 2.0));
}

TEST(Outline, RowsThatDoNotOverlapAreNotPart) {
  EXPECT_TRUE(traceOutline(rowsOf({{{0, 3}}, {{4, 9}}})).polygons.empty());
  EXPECT_FALSE(OutlineTest(Outline()).inside(0.0, 0.0));
}

TEST(Outline, AnEndFarBeyondItsNeighboursIsCutToTheOverlap) {
  const Outline slanted = traceOutline(rowsOf({{{0, 10}}, {{2, 10}}}));
  EXPECT_DOUBLE_EQ(area(slanted.polygons[0]), 9.0);
  const Outline ragged = traceOutline(rowsOf({{{0, 10}}, {{2.5, 10}}}));  // joined straight: 8.75
  EXPECT_DOUBLE_EQ(area(ragged.polygons[0]), 7.5);
  EXPECT_FALSE(OutlineTest(ragged).inside(2.0, 0.5));
}

TEST(Outline, InsideAgreesWithTheWindingNumber) {
  Random random(1);
  for (int round = 0; round < 30; ++round) {
    std::vector<std::vector<Range>> ranges;
    for (int row = 0; row < 12; ++row) {
      std::vector<Range> pieces;
      double x = random.uniform(0.0, 3.0);
      while (x < 9.0) {
        const double end = x + random.uniform(0.5, 5.0);
        pieces.emplace_back(x, end);
        x = end + random.uniform(0.1, 2.0);
      }
      ranges.push_back(pieces);
    }
    const Outline outline = traceOutline(rowsOf(ranges));
    const OutlineTest test(outline);
    for (int k = 0; k < 300; ++k) {
      const double x = random.uniform(-1.0, 15.0);
      const double y = random.uniform(-1.0, 12.0);
      EXPECT_EQ(test.inside(x, y), insideByAngles(outline, x, y)) << x << " " << y;
      const double row = std::floor(y);
      if (!test.inside(x, y)) continue;
      ASSERT_GE(row, 0.0);  // a point of the part lies between pieces of both rows
      double low = 1e9, high = -1e9;
      for (const auto& [begin, end] : ranges[static_cast<std::size_t>(row)])
        low = std::min(low, begin), high = std::max(high, end);
      for (const auto& [begin, end] : ranges[static_cast<std::size_t>(row) + 1])
        low = std::min(low, begin), high = std::max(high, end);
      EXPECT_TRUE(x >= low && x <= high);
    }
  }
}

}  // namespace
}  // namespace scan_to_path::scan
