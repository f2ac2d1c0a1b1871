// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/blind_spots.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

namespace scan_to_path::pipeline {
namespace {

constexpr double spot_spacing = 5e-5;
constexpr double spot_pitch = 0.004;
constexpr double shortest_spot = 0.002;

/// Rows of 60 mm to and fro at z = 10 mm, cut where nothing is seen. What `is_other` says is sampled, but not as part.
scan::SampleRows blindRowsWithout(const std::function<bool(double x, double y)>& is_unseen,
                                  const std::function<bool(double x, double y)>& is_other) {
  scan::SampleRows rows;
  rows.T_cloud_scan.translation() = geometry::Vector3(1.0, 0.5, 0.4);
  rows.pitch = spot_pitch;
  rows.spacing = spot_spacing;
  std::uint32_t index = 0;
  for (int row = 0; row < 10; ++row) {
    std::vector<scan::RowPiece> pieces;
    const bool forward = row % 2 == 0;
    bool is_open = false;
    for (int i = 0; i <= 1200; ++i) {
      const double x = spot_spacing * (forward ? i : 1200 - i), y = spot_pitch * row;
      if (is_unseen(x, y)) {
        if (is_other(x, y)) ++index;
        is_open = false;
        continue;
      }
      if (!is_open) pieces.emplace_back();
      is_open = true;
      scan::RowPiece& piece = pieces.back();
      piece.row = row;
      piece.forward = forward;
      piece.x.push_back(x);
      piece.y.push_back(y);
      piece.z.push_back(0.01);
      piece.index.push_back(index++);
    }
    if (!forward) {
      for (auto& piece : pieces) {
        for (auto* values : {&piece.x, &piece.y, &piece.z}) std::reverse(values->begin(), values->end());
        std::reverse(piece.index.begin(), piece.index.end());
      }
      std::reverse(pieces.begin(), pieces.end());
    }
    rows.pieces.insert(rows.pieces.end(), pieces.begin(), pieces.end());
  }
  return rows;
}

bool nowhereBlind(double, double) { return false; }

TEST(BlindSpots, OfAWholePartAreNone) {
  EXPECT_TRUE(blindSpots(blindRowsWithout(nowhereBlind, nowhereBlind), shortest_spot).empty());
  EXPECT_FALSE(blindSpotNote({}));
  EXPECT_TRUE(blindSpots({}, shortest_spot).empty());
}

// A square over the rows at 12, 16 and 20 mm, a gap of one row, one too short to count, and a row's open end.
TEST(BlindSpots, AreJoinedAcrossRowsTheLargestFirst) {
  const auto in = [](double v, double low, double high) { return v > low && v < high; };
  const auto rows = blindRowsWithout(
      [&](double x, double y) {
        return (in(x, 0.020, 0.029) && in(y, 0.011, 0.021)) || (in(x, 0.010, 0.013) && in(y, 0.007, 0.009)) ||
               (in(x, 0.040, 0.0415) && in(y, 0.007, 0.009)) || (x > 0.05 && in(y, 0.027, 0.029));
      },
      nowhereBlind);
  const auto spots = blindSpots(rows, shortest_spot);
  ASSERT_EQ(spots.size(), 2U);
  // Ends are known to a sample on each side; both ends here lie on samples.
  EXPECT_NEAR(spots[0].length, 0.009, 2.1 * spot_spacing);
  EXPECT_NEAR(spots[0].width, 3 * spot_pitch, 1e-12);
  EXPECT_LT((spots[0].middle - geometry::Vector3(1.0245, 0.516, 0.41)).norm(), 2.1 * spot_spacing);
  EXPECT_NEAR(spots[1].length, 0.003, 2.1 * spot_spacing);
  EXPECT_NEAR(spots[1].width, spot_pitch, 1e-12);
  EXPECT_THAT(*blindSpotNote(spots),
              testing::HasSubstr("in 2 places inside the part's rows, the largest 9.0 x 12.0 mm"));
}

// Two arms that meet: what begins as two spots is one.
TEST(BlindSpots, ThatMeetAreOne) {
  const auto rows = blindRowsWithout(
      [](double x, double y) {
        const bool arms = (x > 0.010 && x < 0.015) || (x > 0.040 && x < 0.045);
        return y > 0.009 && y < 0.025 && (arms || (y > 0.019 && x > 0.010 && x < 0.045));
      },
      nowhereBlind);
  const auto spots = blindSpots(rows, shortest_spot);
  ASSERT_EQ(spots.size(), 1U);
  EXPECT_NEAR(spots[0].length, 0.035, 2.1 * spot_spacing);
  EXPECT_NEAR(spots[0].width, 4 * spot_pitch, 1e-12);
}

TEST(BlindSpots, AreNotWhereTheTableIsSeen) {
  const auto hole = [](double x, double y) { return x > 0.02 && x < 0.03 && y > 0.01 && y < 0.02; };
  EXPECT_EQ(blindSpots(blindRowsWithout(hole, nowhereBlind), shortest_spot).size(), 1U);
  EXPECT_TRUE(blindSpots(blindRowsWithout(hole, hole), shortest_spot).empty());
}

}  // namespace
}  // namespace scan_to_path::pipeline
