// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/quote.h"

#include <gtest/gtest.h>

namespace scan_to_path {
namespace {

TEST(Quote, PrintableTextStaysAsItIs) {
  EXPECT_EQ(escaped("feed ~ 'x'"), "feed ~ 'x'");
  EXPECT_EQ(inQuotes("1.5"), "'1.5'");
  EXPECT_EQ(inQuotes(""), "''");
}

TEST(Quote, OtherBytesAreEscaped) {
  EXPECT_EQ(escaped(std::string_view("a\0b\n\x1b[31m\x7f\xff", 11)), "a\\x00b\\x0a\\x1b[31m\\x7f\\xff");
  EXPECT_EQ(inQuotes("\xc3\xa9"), "'\\xc3\\xa9'");
}

TEST(Quote, LongTextIsCutShort) {
  EXPECT_EQ(escaped(std::string(40, 'a')), std::string(40, 'a'));
  EXPECT_EQ(escaped(std::string(41, 'a')), std::string(40, 'a') + "...");
  EXPECT_EQ(escaped("\n\n\n", 2), "\\x0a\\x0a...");
  EXPECT_EQ(inQuotes(std::string(1000, '\n')).size(), 2U + 4U * 40U + 3U);
}

}  // namespace
}  // namespace scan_to_path
