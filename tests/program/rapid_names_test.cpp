// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/rapid_names.h"

#include <gtest/gtest.h>

#include <set>

#include "../../src/program/rapid_lexer.h"
#include "program_cases.h"
#include "scan_to_path/common/random.h"
#include "scan_to_path/program/rapid_writer.h"
#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

TEST(RapidNames, LegalNames) {
  for (const char* name :
       {"a", "tool_scan", "Wobj1", "x_", "s12_row_3_1", "v", "v5x", "abcdefghijklmnopqrstuvwxyz_12345"}) {
    EXPECT_TRUE(isRapidName(name)) << name;
  }
}

TEST(RapidNames, NamesThatAControllerRefuses) {
  for (const char* name : {"",          "1a",      "_a",          "a-b",
                           "a b",       "a.b",     "t\xc3\xb6ol", "abcdefghijklmnopqrstuvwxyz_123456",
                           "IF",        "if",      "EndProc",     "module",
                           "tool0",     "WObj0",   "fine",        "MoveL",
                           "v100",      "Z5",      "true",        "num",
                           "robtarget", "main",    "TPWrite",     "CalcRobT",
                           "Abs",       "inpos20", "vRot5",       "CRobT"}) {
    EXPECT_FALSE(isRapidName(name)) << name;
    test::expectInputError([&] { checkRapidName("program.tool_name", name); }, "program.tool_name: name is '");
  }
}

/// Names that a program's text uses, but for options, components and the name of a module; in lower case.
std::set<std::string> namesUsed(const std::string& text) {
  const auto tokens = rapidTokens(text, "program.mod");
  std::set<std::string> names;
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    const std::string& before = tokens[i - 1].text;
    if (tokens[i].kind == TokenKind::name && before != "\\" && before != ".") names.insert(tokens[i].text);
  }
  return names;
}

// A routine of the user's that is called as something the program uses would be run in its place, or run itself.
TEST(RapidNames, WhatAProgramUsesIsTaken) {
  ProgramInput input = test::seededInput(3);
  input.options.process_signal = "do_spindle";
  input.options.monitor_configuration = true;
  const auto& options = input.options;
  const std::set<std::string> own = {options.process_signal, "processon", "processoff", options.tool_name,
                                     options.workobject_name};
  const std::set<std::string> used = namesUsed(writeRapid(input).at(1).content);
  for (const char* name : {"waittime", "tpwrite", "calcrobt", "abs", "here", "proc", "part_1"}) {
    EXPECT_EQ(used.count(name), 1U) << name;  // twin: the lexer finds them
  }
  for (const std::string& name : used) {
    if (own.count(name) > 0) continue;
    ProgramOptions taken;
    taken.process_signal = "do_spindle";
    taken.process_on = name;
    EXPECT_THROW(validateProgramOptions(taken), InputError) << name;
  }
}

TEST(RapidNames, AProcessThatWouldCallItselfIsRefused) {
  ProgramOptions options;
  options.process_on = "WaitTime";
  options.process_signal = "do1";
  test::expectInputError([&] { validateProgramOptions(options); }, "program.process_on: name is 'WaitTime'");
  options.process_on = "Turn";
  test::expectInputError([&] { validateProgramOptions(options); }, "no name of the program's own");
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
