// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/rapid_names.h"

#include <gtest/gtest.h>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

TEST(RapidNames, LegalNames) {
  for (const char* name : {"a", "tool_scan", "Wobj1", "x_", "s12_row_3_1", "abcdefghijklmnopqrstuvwxyz_12345"}) {
    EXPECT_TRUE(isRapidName(name)) << name;
  }
}

TEST(RapidNames, NamesThatAControllerRefuses) {
  for (const char* name :
       {"",     "1a", "_a",      "a-b",    "a b",       "a.b",   "t\xc3\xb6ol", "abcdefghijklmnopqrstuvwxyz_123456",
        "IF",   "if", "EndProc", "module", "tool0",     "WObj0", "fine",        "MoveL",
        "v100", "Z5", "true",    "num",    "robtarget", "main"}) {
    EXPECT_FALSE(isRapidName(name)) << name;
    test::expectInputError([&] { checkRapidName("program.tool_name", name); }, "program.tool_name: name is '");
  }
}

TEST(RapidNames, MadeNamesAreLegalForAnyText) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    std::string text(static_cast<std::size_t>(random.uniform(0, 60)), ' ');
    for (auto& c : text) c = static_cast<char>(random.bits());
    const std::string name = rapidName("s7_", text, "_12");
    EXPECT_TRUE(isRapidName(name)) << name;
    EXPECT_EQ(name.substr(0, 3), "s7_");
    EXPECT_EQ(name.substr(name.size() - 3), "_12");
  }
  EXPECT_EQ(rapidName("s0_", "row 3/b", "_1"), "s0_row3b_1");
}

TEST(RapidNames, CommentsArePrintableAscii) { EXPECT_EQ(asciiLine("a\nENDMODULE\t\x7f\xc3\xa9~"), "a?ENDMODULE????~"); }

}  // namespace
}  // namespace scan_to_path::program
