// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/sample_rows.h"

#include <gmock/gmock.h>

namespace scan_to_path::scan {
namespace {

TEST(SampleRows, SubPieceKeepsItsOwnEndsOnly) {
  RowPiece piece;
  piece.row = 3;
  piece.forward = false;
  piece.begins = PieceEnd::step_down;
  piece.ends = PieceEnd::step_up;
  piece.x = {0.0, 1.0, 2.0, 3.0};
  piece.y = {4.0, 5.0, 6.0, 7.0};
  piece.z = {8.0, 9.0, 10.0, 11.0};
  piece.index = {12, 13, 14, 15};
  const RowPiece head = subPiece(piece, 0, 2);
  EXPECT_EQ(head.row, 3);
  EXPECT_FALSE(head.forward);
  EXPECT_EQ(head.begins, PieceEnd::step_down);
  EXPECT_EQ(head.ends, PieceEnd::gap);
  EXPECT_THAT(head.x, ::testing::ElementsAre(0.0, 1.0));
  EXPECT_THAT(head.index, ::testing::ElementsAre(12, 13));
  EXPECT_EQ(subPiece(piece, 2, 4).begins, PieceEnd::gap);
  EXPECT_EQ(subPiece(piece, 2, 4).ends, PieceEnd::step_up);
  SampleRows rows;
  rows.pieces = {piece, head};
  EXPECT_EQ(sampleCount(rows), 6u);
}

TEST(SampleRows, DroppedSamplesAddUpByReason) {
  std::vector<Dropped> dropped;
  addDropped(dropped, "spike", 0);
  EXPECT_TRUE(dropped.empty());
  addDropped(dropped, "spike", 2);
  addDropped(dropped, "turn", 1);
  addDropped(dropped, "spike", 3);
  ASSERT_EQ(dropped.size(), 2u);
  EXPECT_EQ(dropped[0].count, 5u);
}

}  // namespace
}  // namespace scan_to_path::scan
