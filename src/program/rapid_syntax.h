// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scan_to_path/program/program.h"

namespace scan_to_path::program {

/// An expression: literal, name, aggregate, function call, sum or product.
struct Expression {
  enum class Kind { number, text, truth, name, aggregate, call, negative, add, subtract, multiply, divide };
  Kind kind = Kind::number;
  double number = 0.0;            ///< of number and truth (0 or 1)
  std::string text;               ///< of text, name and call
  std::vector<Expression> parts;  ///< operands, elements, arguments
  int line = 0;
};

/// An argument of an instruction: positional when `option` is empty, otherwise \option or \option:=value.
struct Argument {
  std::string option;
  bool has_value = false;
  Expression value;
};

struct Statement {
  enum class Kind { instruction, assignment, conditional };
  Kind kind = Kind::instruction;
  std::string name;                       ///< of the instruction, or of the data assigned to
  std::vector<Argument> arguments;        ///< of an instruction
  std::vector<std::string> names_inside;  ///< of a conditional: every name between IF and ENDIF
  int line = 0;
};

struct Declaration {
  std::string type;
  bool has_value = false;
  Expression value;
  int line = 0;
};

struct RapidRoutine {
  std::vector<Statement> statements;
  std::map<std::string, Declaration> data;
  bool has_parameters = false;
  int line = 0;
};

/// A module as it stands, nothing looked up yet. Names in lower case.
struct RapidModule {
  std::string file;
  std::string name;
  std::map<std::string, Declaration> data;
  std::map<std::string, RapidRoutine> routines;
};

/// Throws InputError with file and line for anything outside the reader's subset.
RapidModule parseRapidModule(const ProgramFile& file);

}  // namespace scan_to_path::program
