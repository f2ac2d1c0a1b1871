// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/row_selection.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::toolpath {
namespace {

constexpr int last_of_all = std::numeric_limits<int>::max();

/// A whole, unsigned number at the front of `text`, taken off it.
std::optional<int> takeNumber(std::string_view& text) {
  int number = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end.ec != std::errc() || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end.ptr - text.data()));
  return number;
}

std::pair<int, int> parseRange(std::string_view text, const std::string& name) {
  std::string_view rest = text;
  const auto first = takeNumber(rest);
  auto last = first;
  if (first && !rest.empty() && rest.front() == '-') {
    rest.remove_prefix(1);
    last = takeNumber(rest);
  }
  if (!first || !last || !rest.empty() || *last < *first) {
    throw InputError(name + ": \"" + std::string(text) + "\" is neither a number nor a range such as 7-9");
  }
  return {*first, *last};
}

}  // namespace

RowSelection RowSelection::all() {
  RowSelection selection;
  selection.ranges_ = {{0, last_of_all}};
  return selection;
}

RowSelection RowSelection::parse(const std::string& text, const std::string& name) {
  const std::string_view list = trimmed(text);
  if (list == "all") return all();
  RowSelection selection;
  if (list.empty()) return selection;
  for (const auto entry : split(list, ',')) selection.ranges_.push_back(parseRange(trimmed(entry), name));
  return selection;
}

bool RowSelection::contains(int row) const {
  return std::any_of(ranges_.begin(), ranges_.end(),
                     [&](const auto& range) { return range.first <= row && row <= range.second; });
}

std::optional<int> RowSelection::beyond(int last) const {
  for (const auto& range : ranges_) {
    if (range.second > last && range.second != last_of_all) return range.second;
  }
  return std::nullopt;
}

std::optional<int> rowNumber(const std::string& segment) {
  constexpr std::string_view word = "row_";
  const auto at = segment.find(word);
  if (at == std::string::npos) return std::nullopt;
  std::string_view rest = std::string_view(segment).substr(at + word.size());
  return takeNumber(rest);
}

}  // namespace scan_to_path::toolpath
