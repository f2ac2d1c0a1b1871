// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "lzf.h"

namespace scan_to_path::scan {

std::optional<std::string> expandLzf(std::string_view data, std::size_t size) {
  constexpr std::size_t longest_copy = 264;  // from three bytes
  if (size / longest_copy > data.size()) return std::nullopt;
  std::string out;
  out.reserve(size);
  std::size_t at = 0;
  while (at < data.size()) {
    const std::size_t control = static_cast<unsigned char>(data[at++]);
    if (control < 32) {  // a run of control + 1 literal bytes
      const std::size_t length = control + 1;
      if (length > data.size() - at || length > size - out.size()) return std::nullopt;
      out.append(data.substr(at, length));
      at += length;
      continue;
    }
    std::size_t length = control >> 5;  // a copy of length + 2 bytes from `back` + 1 before
    if (length == 7) {
      if (at == data.size()) return std::nullopt;
      length += static_cast<unsigned char>(data[at++]);
    }
    if (at == data.size()) return std::nullopt;
    const std::size_t back = ((control & 31) << 8) + static_cast<unsigned char>(data[at++]) + 1;
    length += 2;
    if (back > out.size() || length > size - out.size()) return std::nullopt;
    for (std::size_t k = 0; k < length; ++k) out += out[out.size() - back];  // may overlap itself
  }
  if (out.size() != size) return std::nullopt;
  return out;
}

}  // namespace scan_to_path::scan
