// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/pcd_header.h"

#include <gmock/gmock.h>

#include "support/expect_input_error.h"

namespace scan_to_path::scan {
namespace {

using test::expectInputError;

const std::string whole =
    "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z normal rgb ring\nSIZE 4 4 8 4 4 2\n"
    "TYPE F F F F F U\nCOUNT 1 1 1 3 1 1\nWIDTH 20\nHEIGHT 5\nVIEWPOINT 1 2 3 0.5 -0.5 0.5 -0.5\nPOINTS 100\n"
    "DATA binary\n";

TEST(PcdHeader, ReadsEveryEntry) {
  const PcdHeader header = parsePcdHeader(whole + "\x01\x02", "f");
  ASSERT_EQ(header.fields.size(), 6U);
  EXPECT_EQ(header.fields[2].size, 8U);
  EXPECT_EQ(header.fields[3].count, 3U);
  EXPECT_EQ(header.fields[5].type, 'U');
  const std::size_t offsets[] = {0, 4, 8, 16, 28, 32};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(header.fields[i].offset, offsets[i]) << header.fields[i].name;
  EXPECT_EQ(header.point_size, 34U);
  EXPECT_EQ(header.points, 100U);
  EXPECT_THAT(header.viewpoint, testing::ElementsAre(1.0, 2.0, 3.0, 0.5, -0.5, 0.5, -0.5));
  EXPECT_EQ(header.data, PcdData::binary);
  EXPECT_EQ(header.bytes, whole.size());
  EXPECT_EQ(header.lines, 11U);
}

TEST(PcdHeader, DefaultsAreThoseOfTheFormat) {
  const PcdHeader header = parsePcdHeader("FIELDS x y\nWIDTH 4\nHEIGHT 3\nDATA ascii\n", "f");
  EXPECT_EQ(header.points, 12U);  // no POINTS: width times height
  EXPECT_EQ(header.fields[1].offset, 4U);
  EXPECT_EQ(header.fields[1].type, 'F');
  EXPECT_EQ(header.data, PcdData::ascii);
  EXPECT_THAT(header.viewpoint, testing::ElementsAre(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0));
}

TEST(PcdHeader, TakesDosLineEndsBlanksCommentsAndTheOldName) {
  const std::string text = "# one\r\n\r\nCOLUMNS  x  y z\r\n# two\r\n  POINTS 3\r\nDATA binary_compressed\r\nabc";
  const PcdHeader header = parsePcdHeader(text, "f");
  EXPECT_EQ(header.fields.size(), 3U);
  EXPECT_EQ(header.points, 3U);
  EXPECT_EQ(header.bytes, text.size() - 3);
  EXPECT_EQ(header.data, PcdData::binary_compressed);
}

TEST(PcdHeader, FindsTheFirstNameThatIsThere) {
  const PcdHeader header = parsePcdHeader("FIELDS x t ring\nCOUNT 1 1 0\nDATA ascii\n", "f");
  ASSERT_NE(header.find({"time", "t"}), nullptr);
  EXPECT_EQ(header.find({"time", "t"})->offset, 4U);
  EXPECT_EQ(header.find({"ring"}), nullptr);  // of no values
  EXPECT_EQ(header.find({}), nullptr);
}

TEST(PcdHeader, NamesTheLineAndWhatIsWrong) {
  const auto fails = [](const std::string& text, const std::string& message) {
    expectInputError([&] { parsePcdHeader(text, "f"); }, message);
  };
  fails("", "f line 0: header is cut off");
  fails("FIELDS x\nTYPE F\n", "f line 2: header is cut off");
  fails("FIELDS x\nSIZE 3\nDATA ascii\n", "f line 2: SIZE is 3, must be 1, 2, 4 or 8");
  fails("FIELDS x\nSIZE -4\nDATA ascii\n", "f line 2: SIZE is not such a number");
  fails("FIELDS x\nSIZE 4.5\nDATA ascii\n", "f line 2: SIZE is not such a number");
  fails("FIELDS x\nCOUNT 100001\nDATA ascii\n", "f line 2: COUNT is not such a number, must be a whole number up to");
  fails("FIELDS x\nTYPE D\nDATA ascii\n", "f line 2: TYPE is unknown");
  fails("FIELDS x y\nTYPE F\nDATA ascii\n", "f line 2: number of entries after TYPE is 1, must be 2");
  fails("SIZE 4\nFIELDS x\nDATA ascii\n", "f line 1: number of entries after SIZE is 1, must be 0");
  fails("FIELDS x\nTYPE F\nSIZE 2\nDATA ascii\n", "SIZE of float field is 2, must be 4 or 8");
  fails("FIELDS x\nPOINTS 4294967297\nDATA ascii\n", "f line 2: POINTS is not such a number");
  fails("FIELDS x\nWIDTH 1 2\nDATA ascii\n", "f line 2: WIDTH is not one number");
  fails("FIELDS x\nVIEWPOINT 0 0 0 1 0 0\nDATA ascii\n", "f line 2: VIEWPOINT is not 7 numbers");
  fails("FIELDS x\nVIEWPOINT 0 0 0 1 0 0 nan\nDATA ascii\n", "f line 2: VIEWPOINT is not 7 numbers");
  fails("FIELDS x\nDATA\n", "f line 2: DATA is unknown");
  fails("FIELDS x\nCOLOUR red\nDATA ascii\n", "f line 2: header entry is unknown");
}

}  // namespace
}  // namespace scan_to_path::scan
