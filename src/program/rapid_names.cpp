// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/rapid_names.h"

#include <algorithm>
#include <functional>
#include <set>

#include "scan_to_path/common/error.h"

namespace scan_to_path::program {
namespace {

// What a program must not call anything of its own. A user's routine of an instruction's name would call itself.
const std::set<std::string, std::less<>> taken_names = {
    // reserved words of RAPID
    "alias", "and", "backward", "case", "connect", "const", "default", "div", "do", "else", "elseif", "endfor",
    "endfunc", "endif", "endmodule", "endproc", "endrecord", "endtest", "endtrap", "endwhile", "error", "exit", "false",
    "for", "from", "func", "goto", "if", "inout", "local", "mod", "module", "nostepin", "not", "noview", "or", "pers",
    "proc", "raise", "readonly", "record", "retry", "return", "step", "sysmodule", "task", "test", "then", "to", "trap",
    "true", "trynext", "undo", "var", "viewonly", "while", "with", "xor",
    // data and data types that RobotWare predefines
    "main", "tool0", "wobj0", "load0", "fine", "vmax", "pi", "high", "low", "errno", "intno", "diskhome", "stempty",
    "eof_num", "eof_bin", "bool", "num", "dnum", "string", "byte", "pos", "orient", "pose", "confdata", "extjoint",
    "robtarget", "robjoint", "jointtarget", "speeddata", "zonedata", "stoppointdata", "tooldata", "wobjdata",
    "loaddata", "clock", "errnum", "intnum", "iodev", "datapos", "mecunit", "motsetdata", "progdisp", "rawbytes",
    "restartdata", "shapedata", "signaldi", "signaldo", "signalai", "signalao", "signalgi", "signalgo", "switch",
    "symnum", "taskid", "trapdata", "triggdata", "triggios", "tunetype", "wzstationary", "wztemporary",
    // its instructions
    "accset", "actunit", "add", "break", "clear", "clkreset", "clkstart", "clkstop", "close", "confj", "confl",
    "deactunit", "decr", "eoffsoff", "eoffson", "eoffsset", "errlog", "errwrite", "exitcycle", "gripload", "idelete",
    "idisable", "ienable", "incr", "invertdo", "isignaldi", "isignaldo", "isleep", "itimer", "iwatch", "load",
    "mechunitload", "motionsup", "moveabsj", "movec", "movecdo", "moveextj", "movej", "movejdo", "movel", "moveldo",
    "open", "pathacclim", "pdispoff", "pdispon", "pdispset", "pulsedo", "reset", "restopath", "rewind", "save",
    "searchc", "searchl", "set", "setao", "setdo", "setgo", "singarea", "skipwarn", "softact", "softdeact", "startload",
    "startmove", "stop", "stopmove", "storepath", "tperase", "tpreadfk", "tpreadnum", "tpshow", "tpwrite", "triggc",
    "triggequip", "triggint", "triggio", "triggj", "triggl", "tuneservo", "unload", "velset", "waitdi", "waitdo",
    "waitload", "waitrob", "waittime", "waituntil", "write", "writebin", "writestrbin",
    // its functions
    "abs", "acos", "aoutput", "asin", "atan", "atan2", "bitand", "bitcheck", "bitlsh", "bitneg", "bitor", "bitrsh",
    "bitxor", "calcjointt", "calcrobt", "cdate", "cjointt", "clkread", "cos", "cpos", "crobt", "ctime", "ctool",
    "cwobj", "defaccframe", "defdframe", "defframe", "dim", "distance", "dotprod", "doutput", "eulerzyx", "exp",
    "gettime", "goutput", "ispers", "isvar", "mirpos", "norient", "numtostr", "offs", "opmode", "orientzyx", "orobt",
    "poseinv", "posemult", "posevect", "pow", "present", "readbin", "readnum", "readstr", "reltool", "round", "runmode",
    "sin", "sqrt", "strfind", "strlen", "strmap", "strmatch", "strmemb", "strorder", "strpart", "strtobyte", "strtoval",
    "tan", "testdi", "trunc", "valtostr", "vectmagn"};

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isNameCharacter(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '_'; }

std::string inLowerCase(std::string_view text) {
  std::string lower(text);
  for (auto& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

/// Predefined speeds and zones: v5 … v7000, vlin10 …, vrot1 …, z0 … z200, inpos20 ….
bool isPredefinedSeries(const std::string& lower) {
  const std::string word = lower.substr(0, lower.find_last_not_of("0123456789") + 1);
  if (word.size() == lower.size()) return false;
  return word == "v" || word == "vlin" || word == "vrot" || word == "z" || word == "inpos";
}

}  // namespace

bool isRapidName(std::string_view name) {
  if (name.empty() || name.size() > rapid_name_length || !isLetter(name.front())) return false;
  if (!std::all_of(name.begin(), name.end(), isNameCharacter)) return false;
  const std::string lower = inLowerCase(name);
  return !isPredefinedSeries(lower) && taken_names.count(lower) == 0;
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
