// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/quote.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::mesh {

/// Takes the next line off `text`, without its end (LF or CR LF). Precondition: text is not empty.
inline std::string_view takeLine(std::string_view& text) {
  const auto end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

/// Takes the next blank-separated word off `line`; empty when there is none.
inline std::string_view takeWord(std::string_view& line) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const auto begin = line.find_first_not_of(blanks);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  line.remove_prefix(begin);
  const auto length = std::min(line.find_first_of(blanks), line.size());
  const std::string_view word = line.substr(0, length);
  line.remove_prefix(length);
  return word;
}

/// Takes a number off `line`. Throws InputError naming `where()` and `quantity` when there is none.
template <class Where>
double takeNumber(std::string_view& line, const Where& where, const char* quantity) {
  const std::string_view word = takeWord(line);
  double value = 0.0;
  if (!parseNumber(word, value)) {
    throw InputError(where(), quantity, word.empty() ? "missing" : inQuotes(word), "a number");
  }
  return value;
}

}  // namespace scan_to_path::mesh
