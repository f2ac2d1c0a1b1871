// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../../src/program/rapid_syntax.h"

#include <gtest/gtest.h>

#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

TEST(RapidSyntax, ModuleOfDataAndRoutines) {
  const auto module = parseRapidModule({"m.mod",
                                        "MODULE M(SYSMODULE)\nLOCAL CONST num a:=1+2*3;\nVAR bool b;\n"
                                        "FUNC num F(num x)\nRETURN x;\nENDFUNC\nTRAP t\nENDTRAP\n"
                                        "PROC P(num x)\nENDPROC\n"
                                        "LOCAL PROC main()\nVAR num n;\nn:=1;\nIF n=1 THEN\nStop;\nENDIF\n"
                                        "MoveL\\Conc,p,v10\\V:=3,fine,t\\WObj:=w;\nENDPROC\nENDMODULE"});
  EXPECT_EQ(module.name, "m");
  EXPECT_EQ(module.data.at("a").type, "num");
  EXPECT_EQ(module.data.at("a").value.kind, Expression::Kind::add);
  EXPECT_FALSE(module.data.at("b").has_value);
  EXPECT_TRUE(module.routines.at("p").has_parameters);
  const auto& main = module.routines.at("main");
  EXPECT_EQ(main.data.count("n"), 1u);
  ASSERT_EQ(main.statements.size(), 3u);
  EXPECT_EQ(main.statements[0].kind, Statement::Kind::assignment);
  EXPECT_EQ(main.statements[1].kind, Statement::Kind::conditional);
  EXPECT_EQ(main.statements[1].names_inside, (std::vector<std::string>{"if", "n", "then", "stop", "endif"}));
  const auto& arguments = main.statements[2].arguments;
  ASSERT_EQ(arguments.size(), 7u);
  EXPECT_EQ(arguments[0].option, "conc");
  EXPECT_FALSE(arguments[0].has_value);
  EXPECT_EQ(arguments[3].option, "v");
  EXPECT_DOUBLE_EQ(arguments[3].value.number, 3.0);
  EXPECT_EQ(arguments[6].value.text, "w");
  EXPECT_EQ(main.statements[2].line, 17);
}

TEST(RapidSyntax, MistakesAreNamedWithTheirLine) {
  for (const auto& [text, message] : {
           std::pair{"PROC main()\nENDPROC", "expected module"},
           std::pair{"MODULE 3\nENDMODULE", "expected a name, found '3'"},
           std::pair{"MODULE M\nx;\nENDMODULE", "line 2: 'x' is neither data nor a routine"},
           std::pair{"MODULE M\nCONST num a=1;\nENDMODULE", "line 2: expected ;, found '='"},
           std::pair{"MODULE M\nCONST num a:=b.c;\nENDMODULE", "components of 'b' are not read"},
           std::pair{"MODULE M\nCONST num a:=f(\\x);\nENDMODULE", "optional arguments of functions"},
           std::pair{"MODULE M\nPROC a()\nENDPROC\nPROC A()\nENDPROC\nENDMODULE", "routine 'a' is there twice"},
           std::pair{"MODULE M\nPROC a()\nWHILE TRUE DO\nENDWHILE\nENDPROC\nENDMODULE", "line 3: 'while' is not read"},
       }) {
    test::expectInputError([t = text] { parseRapidModule({"m.mod", t}); }, message);
  }
}

}  // namespace
}  // namespace scan_to_path::program
