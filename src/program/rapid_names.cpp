// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/rapid_names.h"

#include <algorithm>
#include <array>

#include "scan_to_path/common/error.h"

namespace scan_to_path::program {
namespace {

// Reserved words of RAPID, then names that RobotWare predefines and a program must not take.
constexpr std::array<std::string_view, 94> taken_names = {
    "alias",    "and",       "backward", "case",        "connect",   "const",     "default",  "div",       "do",
    "else",     "elseif",    "endfor",   "endfunc",     "endif",     "endmodule", "endproc",  "endrecord", "endtest",
    "endtrap",  "endwhile",  "error",    "exit",        "false",     "for",       "from",     "func",      "goto",
    "if",       "inout",     "local",    "mod",         "module",    "nostepin",  "not",      "noview",    "or",
    "pers",     "proc",      "raise",    "readonly",    "record",    "retry",     "return",   "step",      "sysmodule",
    "task",     "test",      "then",     "to",          "trap",      "true",      "trynext",  "undo",      "var",
    "viewonly", "while",     "with",     "xor",         "main",      "tool0",     "wobj0",    "load0",     "fine",
    "vmax",     "bool",      "num",      "dnum",        "string",    "pos",       "orient",   "pose",      "confdata",
    "extjoint", "robtarget", "robjoint", "jointtarget", "speeddata", "zonedata",  "tooldata", "wobjdata",  "loaddata",
    "movel",    "movej",     "moveabsj", "movec",       "offs",      "setdo",     "set",      "reset",     "stop",
    "break",    "confl",     "confj",    "distance"};

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isNameCharacter(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '_'; }

std::string inLowerCase(std::string_view text) {
  std::string lower(text);
  for (auto& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

/// Predefined speeds and zones: v5 … v7000, z0 … z200.
bool isPredefinedSeries(const std::string& lower) {
  return lower.size() > 1 && (lower[0] == 'v' || lower[0] == 'z') &&
         std::all_of(lower.begin() + 1, lower.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

bool isRapidName(std::string_view name) {
  if (name.empty() || name.size() > rapid_name_length || !isLetter(name.front())) return false;
  if (!std::all_of(name.begin(), name.end(), isNameCharacter)) return false;
  const std::string lower = inLowerCase(name);
  return !isPredefinedSeries(lower) && std::find(taken_names.begin(), taken_names.end(), lower) == taken_names.end();
}

void checkRapidName(const std::string& where, const std::string& name) {
  if (isRapidName(name)) return;
  throw InputError(where, "name", "'" + asciiLine(name) + "'",
                   "a letter, then letters, digits or '_', at most " + std::to_string(rapid_name_length) +
                       " characters, no reserved or predefined word");
}

std::string rapidName(const std::string& prefix, std::string_view text, const std::string& suffix) {
  std::string name = prefix;
  for (const char c : text) {
    if (name.size() + suffix.size() >= rapid_name_length) break;
    if (isNameCharacter(c)) name += c;
  }
  return name + suffix;
}

std::string asciiLine(std::string_view text) {
  std::string line(text);
  for (auto& c : line) {
    if (c < ' ' || c > '~') c = '?';
  }
  return line;
}

}  // namespace scan_to_path::program
