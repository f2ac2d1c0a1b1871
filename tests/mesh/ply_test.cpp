// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/ply.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>

#include "scan_to_path/common/error.h"
#include "support/expect_input_error.h"

namespace scan_to_path::mesh {
namespace {

using test::expectInputError;
using ::testing::ElementsAre;

const char* const ascii_cloud =
    "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nobj_info none\r\nelement vertex 2\r\nproperty double x\r\n"
    "property list uchar int near\r\nproperty int line\r\nend_header\r\n"
    "1.5 2 7 8 -3\r\n\r\n-2.5e-3 0 4";

struct Rows {
  std::vector<std::vector<double>> values;
  std::vector<std::vector<double>> lists;  // of property 1
};

Rows readAll(const std::string& content, const std::string& wanted) {
  PlyReader reader(content, "f.ply");
  Rows rows;
  PlyRow row;
  while (const PlyElement* element = reader.nextElement()) {
    if (element->name != wanted) continue;
    for (std::uint64_t i = 0; i < element->count; ++i) {
      reader.readRow(row);
      rows.values.push_back(row.values);
      if (row.lists.size() > 1) rows.lists.push_back(row.lists[1]);
    }
  }
  return rows;
}

template <class T>
void append(std::string& bytes, T value, bool big_endian) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  // The tests run on little-endian machines only, as Debian's amd64 and arm64 are.
  if (big_endian) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string everyType(bool big_endian) {
  std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                      "_endian 1.0\nelement skipped 1\nproperty list ushort double d\nelement fixed 2\n"
                      "property short s\nelement row 1\nproperty char a\nproperty list int uint8 b\n"
                      "property int16 c\nproperty uint16 d\nproperty int e\nproperty uint32 f\nproperty float g\n"
                      "property float64 h\nend_header\n";
  append<std::uint16_t>(bytes, 1, big_endian);
  append<double>(bytes, 9.0, big_endian);
  append<std::int16_t>(bytes, 1, big_endian);
  append<std::int16_t>(bytes, 2, big_endian);
  append<std::int8_t>(bytes, -7, big_endian);
  append<std::int32_t>(bytes, 2, big_endian);
  append<std::uint8_t>(bytes, 200, big_endian);
  append<std::uint8_t>(bytes, 3, big_endian);
  append<std::int16_t>(bytes, -300, big_endian);
  append<std::uint16_t>(bytes, 65000, big_endian);
  append<std::int32_t>(bytes, -70000, big_endian);
  append<std::uint32_t>(bytes, 4000000000U, big_endian);
  append<float>(bytes, 0.25F, big_endian);
  append<double>(bytes, 0.1, big_endian);
  return bytes;
}

TEST(Ply, ReadsAsciiRowsWithListsCommentsAndBlankLines) {
  const Rows rows = readAll(ascii_cloud, "vertex");
  ASSERT_EQ(rows.values.size(), 2U);
  EXPECT_THAT(rows.values[0], ElementsAre(1.5, 2, -3));
  EXPECT_THAT(rows.lists[0], ElementsAre(7, 8));
  EXPECT_THAT(rows.values[1], ElementsAre(-2.5e-3, 0, 4));
  EXPECT_TRUE(rows.lists[1].empty());
}

TEST(Ply, ReadsEveryTypeInBothByteOrdersPastSkippedElements) {
  for (const bool big_endian : {false, true}) {
    const Rows rows = readAll(everyType(big_endian), "row");
    ASSERT_EQ(rows.values.size(), 1U);
    EXPECT_THAT(rows.values[0], ElementsAre(-7, 2, -300, 65000, -70000, 4000000000.0, 0.25, 0.1));
    EXPECT_THAT(rows.lists[0], ElementsAre(200, 3));
  }
}

TEST(Ply, HeaderTellsCloudFromMesh) {
  EXPECT_FALSE(parsePlyHeader(ascii_cloud, "c").hasFaces());
  EXPECT_TRUE(parsePlyHeader("ply\nformat ascii 1.0\nelement face 1\nend_header\n", "m").hasFaces());
  EXPECT_FALSE(parsePlyHeader("ply\nformat ascii 1.0\nelement face 0\nend_header\n", "m").hasFaces());
  EXPECT_TRUE(isPly("ply\r\n"));
  EXPECT_FALSE(isPly("plyers\n"));
  EXPECT_FALSE(isPly("ply"));
}

TEST(Ply, FindsElementsAndProperties) {
  const PlyHeader header = parsePlyHeader(ascii_cloud, "c");
  ASSERT_NE(header.find("vertex"), nullptr);
  EXPECT_EQ(header.find("face"), nullptr);
  EXPECT_EQ(header.find("vertex")->find("line"), std::optional<std::size_t>(2));
  EXPECT_EQ(header.find("vertex")->find("z"), std::nullopt);
}

TEST(Ply, RefusesMalformedHeaders) {
  const auto parse = [](const char* text) { return [text] { parsePlyHeader(text, "f.ply"); }; };
  expectInputError(parse("plyx\n"), "f.ply line 1: first line is 'plyx\\x0a', must be ply");
  expectInputError(parse("ply\nformat ascii 1.0\n"), "no end_header");
  expectInputError(parse("ply\nend_header\n"), "no format line");
  expectInputError(parse("ply\nformat binary 1.0\n"), "f.ply line 2: format is 'binary'");
  expectInputError(parse("ply\nproperty float x\n"), "line 2: header line is 'property'");
  expectInputError(parse("ply\nelement vertex -1\n"), "element count is -1");
  expectInputError(parse("ply\nelement vertex nan\n"), "element count is nan");
  expectInputError(parse("ply\nelement vertex 1e300\n"), "element count");
  expectInputError(parse("ply\nelement vertex 1\nproperty half x\n"), "property type is 'half'");
  expectInputError(parse("ply\nelement vertex 1\nproperty list float int x\n"), "list length type");
  expectInputError(parse("ply\nelement vertex 1\nproperty float\n"), "property name is missing");
}

TEST(Ply, RefusesCountsThatTheFileHasNoRoomFor) {
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  const std::string tail = "\nproperty float x\nend_header\n";
  expectInputError([&] { readAll(head + "3" + tail + std::string(11, '\0'), "vertex"); },
                   "row count is 3, must be at most 2");
  expectInputError([&] { readAll(head + "9007199254740992" + tail, "vertex"); }, "row count");
  expectInputError([&] { readAll(head + "4\nend_header\nabcd", "vertex"); }, "rows but no properties");
  const std::string list =
      "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list int double i\nend_header\n";
  expectInputError([&] { readAll(list + std::string("\xff\xff\xff\x7f", 4), "face"); }, "list length is 2147483647");
  expectInputError([&] { readAll(list + std::string("\xff\xff\xff\xff", 4), "face"); }, "list length is -1");
}

TEST(Ply, RefusesMalformedAsciiRowsWithTheirLine) {
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nend_header\n";
  expectInputError([&] { readAll(head + "1 2\n3\n\n", "vertex"); }, "f.ply line 8: y is missing, must be a number");
  expectInputError([&] { readAll(head + "1 2\n3 4 5\n", "vertex"); }, "line 8: end of row is '5'");
  expectInputError([&] { readAll(head + "1 two\n3 4\n", "vertex"); }, "line 7: y is 'two'");
  expectInputError([&] { readAll(head + "1 2\n      \n   ", "vertex"); }, "file ends 1 rows before the end");
}

// Cutting the file anywhere must give an error, never a short read.
TEST(Ply, RefusesEveryTruncation) {
  for (const bool big_endian : {false, true}) {
    const std::string whole = everyType(big_endian);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      EXPECT_THROW(readAll(whole.substr(0, length), "row"), InputError) << "cut at byte " << length;
    }
  }
}

TEST(Ply, PassesNanOnToTheCaller) {
  const std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\nnan\n";
  EXPECT_TRUE(std::isnan(readAll(text, "vertex").values[0][0]));
}

}  // namespace
}  // namespace scan_to_path::mesh
