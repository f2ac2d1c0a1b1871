// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rapid_syntax.h"

#include <algorithm>
#include <set>

#include "rapid_lexer.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path::program {
namespace {

using Kind = Expression::Kind;

/// Deeper nesting than any program has; bounds the recursion on hostile text.
constexpr int deepest_expression = 50;

const std::set<std::string> unread_words = {"for",  "while", "test",  "goto",    "connect", "error",
                                            "undo", "raise", "retry", "trynext", "backward"};

class Parser {
public:
  explicit Parser(const ProgramFile& file) : file_(file.name), tokens_(rapidTokens(file.content, file.name)) {}

  RapidModule run() {
    RapidModule module;
    module.file = file_;
    takeName("module");
    module.name = name();
    if (take("(")) skipPast(")");
    while (!takeIfName("endmodule")) item(module);
    if (token().kind != TokenKind::end) fail("text after ENDMODULE");
    return module;
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + " line " + std::to_string(token().line) + ": " + what);
  }

  const Token& token() const { return tokens_[at_]; }
  void advance() {
    if (token().kind == TokenKind::end) fail("the module ends too early");
    ++at_;
  }
  bool isSymbol(const char* text) const { return token().kind == TokenKind::symbol && token().text == text; }
  bool isName(const char* text) const { return token().kind == TokenKind::name && token().text == text; }
  bool take(const char* symbol) {
    if (!isSymbol(symbol)) return false;
    advance();
    return true;
  }
  void expect(const char* symbol) {
    if (!take(symbol)) fail(std::string("expected ") + symbol + ", found '" + token().text.substr(0, 40) + "'");
  }
  bool takeIfName(const char* text) {
    if (!isName(text)) return false;
    advance();
    return true;
  }
  void takeName(const char* text) {
    if (!takeIfName(text)) fail(std::string("expected ") + text);
  }
  std::string name() {
    if (token().kind != TokenKind::name) fail("expected a name, found '" + token().text.substr(0, 40) + "'");
    std::string text = token().text;
    advance();
    return text;
  }
  void skipPast(const char* symbol) {
    while (!isSymbol(symbol)) advance();
    advance();
  }
  void skipPastName(const char* text) {
    while (!isName(text)) advance();
    advance();
  }

  void item(RapidModule& module) {
    takeIfName("local") || takeIfName("task");
    if (isName("proc")) {
      routine(module);
    } else if (takeIfName("func")) {
      skipPastName("endfunc");
    } else if (takeIfName("trap")) {
      skipPastName("endtrap");
    } else if (isName("const") || isName("pers") || isName("var")) {
      declaration(module.data);
    } else {
      fail("'" + token().text.substr(0, 40) + "' is neither data nor a routine");
    }
  }

  void declaration(std::map<std::string, Declaration>& data) {
    advance();
    Declaration declared;
    declared.line = token().line;
    declared.type = name();
    const std::string key = name();
    if (take("{")) fail("arrays are not read");
    if (take(":=")) {
      declared.has_value = true;
      declared.value = sum(0);
    }
    expect(";");
    if (!data.emplace(key, std::move(declared)).second) fail("'" + key + "' is declared twice");
  }

  void routine(RapidModule& module) {
    RapidRoutine routine;
    routine.line = token().line;
    takeName("proc");
    const std::string key = name();
    expect("(");
    routine.has_parameters = !isSymbol(")");
    skipPast(")");
    while (!takeIfName("endproc")) {
      if (isName("const") || isName("pers") || isName("var")) {
        declaration(routine.data);
      } else {
        routine.statements.push_back(statement());
      }
    }
    if (!module.routines.emplace(key, std::move(routine)).second) fail("routine '" + key + "' is there twice");
  }

  Statement statement() {
    Statement made;
    made.line = token().line;
    if (isName("if")) return conditional();
    if (token().kind == TokenKind::name && unread_words.count(token().text) > 0) {
      fail("'" + token().text + "' is not read");
    }
    made.name = name();
    if (isSymbol(":=") || isSymbol(".") || isSymbol("{")) {
      made.kind = Statement::Kind::assignment;
      skipPast(";");
    } else {
      made.arguments = arguments();
    }
    return made;
  }

  /// Kept as the names in it only: what is done under a condition must not concern the path.
  Statement conditional() {
    Statement made;
    made.kind = Statement::Kind::conditional;
    made.line = token().line;
    int depth = 0;
    do {
      if (isName("endproc")) fail("IF without ENDIF");
      if (isName("if")) ++depth;
      if (isName("endif")) --depth;
      if (token().kind == TokenKind::name) made.names_inside.push_back(token().text);
      advance();
    } while (depth > 0);
    return made;
  }

  std::vector<Argument> arguments() {
    std::vector<Argument> list;
    while (!take(";")) {
      if (take(",")) continue;
      Argument argument;
      if (take("\\")) {
        argument.option = name();
        argument.has_value = take(":=");
        if (argument.has_value) argument.value = sum(0);
      } else {
        argument.has_value = true;
        argument.value = sum(0);
      }
      list.push_back(std::move(argument));
    }
    return list;
  }

  static Expression binary(Kind kind, Expression left, Expression right) {
    Expression made;
    made.kind = kind;
    made.line = left.line;
    made.parts.push_back(std::move(left));
    made.parts.push_back(std::move(right));
    return made;
  }

  Expression sum(int depth) {
    if (depth > deepest_expression) fail("expression is nested too deeply");
    Expression left = product(depth);
    for (int terms = 0; isSymbol("+") || isSymbol("-"); ++terms) {
      if (terms > deepest_expression) fail("expression is too long");
      const Kind kind = isSymbol("+") ? Kind::add : Kind::subtract;
      advance();
      left = binary(kind, std::move(left), product(depth));
    }
    return left;
  }

  Expression product(int depth) {
    Expression left = factor(depth);
    for (int terms = 0; isSymbol("*") || isSymbol("/"); ++terms) {
      if (terms > deepest_expression) fail("expression is too long");
      const Kind kind = isSymbol("*") ? Kind::multiply : Kind::divide;
      advance();
      left = binary(kind, std::move(left), factor(depth));
    }
    return left;
  }

  Expression factor(int depth) {
    if (depth > deepest_expression) fail("expression is nested too deeply");
    Expression made;
    made.line = token().line;
    if (take("+")) return factor(depth + 1);
    if (take("-")) {
      made.kind = Kind::negative;
      made.parts.push_back(factor(depth + 1));
    } else if (take("(")) {
      made = sum(depth + 1);
      expect(")");
    } else if (take("[")) {
      made.kind = Kind::aggregate;
      elements(made, "]", depth);
    } else if (token().kind == TokenKind::number) {
      made.number = token().number;
      advance();
    } else if (token().kind == TokenKind::string) {
      made.kind = Kind::text;
      made.text = token().text;
      advance();
    } else {
      nameOrCall(made, depth);
    }
    return made;
  }

  void nameOrCall(Expression& made, int depth) {
    made.text = name();
    made.kind = made.text == "true" || made.text == "false" ? Kind::truth : Kind::name;
    made.number = made.text == "true" ? 1.0 : 0.0;
    if (isSymbol(".") || isSymbol("{")) fail("components of '" + made.text.substr(0, 40) + "' are not read");
    if (made.kind == Kind::name && take("(")) {
      made.kind = Kind::call;
      elements(made, ")", depth);
    }
  }

  void elements(Expression& made, const char* close, int depth) {
    if (take(close)) return;
    do {
      if (isSymbol("\\")) fail("optional arguments of functions are not read");
      made.parts.push_back(sum(depth + 1));
    } while (take(","));
    expect(close);
  }

  std::string file_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

}  // namespace

RapidModule parseRapidModule(const ProgramFile& file) { return Parser(file).run(); }

}  // namespace scan_to_path::program
