// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../../src/program/rapid_lexer.h"

#include <gtest/gtest.h>

#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

TEST(RapidLexer, WordsNumbersAndSymbols) {
  const auto tokens =
      rapidTokens("%%%\nVERSION:1\n%%%\nMoveL p_1:=[-1.5,9E+09,.25,3.] ! not this\n\\\"a \"\"b\"\"\"<>", "f");
  const char* texts[] = {"movel", "p_1", ":=", "[", "-",  "1.5",     ",",  "9E+09", ",",
                         ".25",   ",",   "3.", "]", "\\", "a \"b\"", "<>", ""};
  ASSERT_EQ(tokens.size(), std::size(texts));
  for (std::size_t i = 0; i < tokens.size(); ++i) EXPECT_EQ(tokens[i].text, texts[i]) << i;
  EXPECT_DOUBLE_EQ(tokens[5].number, 1.5);
  EXPECT_DOUBLE_EQ(tokens[7].number, 9e9);
  EXPECT_DOUBLE_EQ(tokens[9].number, 0.25);
  EXPECT_DOUBLE_EQ(tokens[11].number, 3.0);
  EXPECT_EQ(tokens[0].line, 4);
  EXPECT_EQ(tokens[14].line, 5);
  EXPECT_EQ(tokens.back().kind, TokenKind::end);
}

TEST(RapidLexer, EndsOfTextEverywhere) {
  EXPECT_EQ(rapidTokens("", "f").size(), 1u);
  EXPECT_EQ(rapidTokens("! comment to the end", "f").size(), 1u);
  EXPECT_EQ(rapidTokens(" \t\r\n\n", "f").back().line, 3);
  EXPECT_EQ(rapidTokens("a", "f").size(), 2u);
  EXPECT_EQ(rapidTokens(":", "f").size(), 2u);
  for (const char* text : {"1E", "1E+", "\"", "\"a\nb\"", "%%% no end", "#", "\x80", "1E999"}) {
    test::expectInputError([&] { rapidTokens(text, "f.mod"); }, "f.mod line 1: ");
  }
}

}  // namespace
}  // namespace scan_to_path::program
