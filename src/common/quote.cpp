// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/quote.h"

namespace scan_to_path {

std::string escaped(std::string_view text, std::size_t longest) {
  constexpr char digits[] = "0123456789abcdef";
  std::string shown;
  for (const char c : text.substr(0, longest)) {
    if (c >= ' ' && c <= '~') {
      shown += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    shown += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
  }
  return text.size() > longest ? shown + "..." : shown;
}

std::string inQuotes(std::string_view text) { return "'" + escaped(text) + "'"; }

}  // namespace scan_to_path
