// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/row_selection.h"

#include <gmock/gmock.h>

#include "support/expect_input_error.h"

namespace scan_to_path::toolpath {
namespace {

using ::testing::ElementsAre;

TEST(RowSelection, TakesNumbersAndRanges) {
  const auto rows = RowSelection::parse(" 3, 7-9 ", "rows");
  std::vector<int> chosen;
  for (int row = 0; row < 12; ++row) {
    if (rows.contains(row)) chosen.push_back(row);
  }
  EXPECT_THAT(chosen, ElementsAre(3, 7, 8, 9));
  EXPECT_FALSE(RowSelection::parse("", "rows").contains(0));
  EXPECT_TRUE(RowSelection::parse(" ", "rows").empty());
  EXPECT_TRUE(RowSelection::parse("all", "rows").contains(1234));
}

TEST(RowSelection, TellsRowsThatAreNotThere) {
  EXPECT_EQ(RowSelection::parse("3, 7-9", "rows").beyond(9), std::nullopt);
  EXPECT_EQ(RowSelection::parse("3, 7-9", "rows").beyond(8), 9);
  EXPECT_EQ(RowSelection::all().beyond(0), std::nullopt);
  EXPECT_EQ(RowSelection().beyond(0), std::nullopt);
}

TEST(RowSelection, RefusesWhatIsNoRange) {
  for (const char* text : {"x", "3-", "9-7", "-3", "1 2", "1,,2", "3.5", "99999999999"}) {
    test::expectInputError([&] { RowSelection::parse(text, "path.skip_rows"); }, "path.skip_rows: \"");
  }
}

TEST(RowNumber, IsInTheSegmentsName) {
  EXPECT_EQ(rowNumber("row_3"), 3);
  EXPECT_EQ(rowNumber("row_12_1"), 12);
  EXPECT_EQ(rowNumber("pass_1_row_40"), 40);
  EXPECT_EQ(rowNumber("link_3_4"), std::nullopt);
  EXPECT_EQ(rowNumber("approach"), std::nullopt);
  EXPECT_EQ(rowNumber("row_x"), std::nullopt);
}

}  // namespace
}  // namespace scan_to_path::toolpath
