// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/row_directions.h"

#include <gtest/gtest.h>

#include "support/expect_input_error.h"

namespace scan_to_path::process {
namespace {

TEST(RowDirections, TurnRowsRoundFromWhatTheOrderSays) {
  const RowDirections to_and_fro(RowOrder::zig_zag, "");
  const RowDirections turned(RowOrder::zig_zag, "1, 4-5");
  const RowDirections one_way(RowOrder::one_way, "1, 4-5");
  for (int row = 0; row < 8; ++row) {
    const bool is_named = row == 1 || row == 4 || row == 5;
    EXPECT_EQ(to_and_fro.isForward(row), row % 2 == 0) << row;
    EXPECT_EQ(turned.isForward(row), (row % 2 == 0) != is_named) << row;
    EXPECT_EQ(one_way.isForward(row), !is_named) << row;
  }
}

TEST(RowDirections, DriveThePiecesOfARowInItsOwnDirection) {
  std::vector<Row> rows(5);
  for (int i = 0; i < 5; ++i) {
    rows[static_cast<std::size_t>(i)].row = i < 2 ? 0 : 1;
    rows[static_cast<std::size_t>(i)].piece = i < 2 ? i : i - 2;
  }
  const auto pieces = [&](const std::string& reverse_rows) {
    std::vector<int> pieces;
    for (const Row& row : RowDirections(RowOrder::zig_zag, reverse_rows).driven(rows)) pieces.push_back(row.piece);
    return pieces;
  };
  EXPECT_EQ(pieces(""), (std::vector<int>{0, 1, 2, 1, 0}));
  EXPECT_EQ(pieces("1"), (std::vector<int>{0, 1, 0, 1, 2}));
  EXPECT_EQ(pieces("all"), (std::vector<int>{1, 0, 0, 1, 2}));
}

TEST(RowDirections, NameRowsThatAreThere) {
  EXPECT_NO_THROW(checkThatRowsAreThere("3, 7-9", "path.skip_rows", 9));
  EXPECT_NO_THROW(checkThatRowsAreThere("all", "path.skip_rows", 0));
  test::expectInputError([] { checkThatRowsAreThere("3, 7-9", "path.skip_rows", 8); },
                         "path.skip_rows names row 9, the part's last one is row 8");
}

}  // namespace
}  // namespace scan_to_path::process
