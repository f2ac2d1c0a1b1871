// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scan_to_path::scan {

enum class PcdData { ascii, binary, binary_compressed };

struct PcdField {
  std::string name;
  std::size_t size = 4;    ///< bytes of one value: 1, 2, 4 or 8
  char type = 'F';         ///< F, U or I
  std::size_t count = 1;   ///< values per point
  std::size_t offset = 0;  ///< bytes from the start of a point
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  std::array<double, 7> viewpoint = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};  ///< x y z, then quaternion w x y z
  PcdData data = PcdData::ascii;
  std::size_t point_size = 0;  ///< bytes of one point
  std::size_t bytes = 0;       ///< of the header; the data starts there
  std::size_t lines = 0;       ///< of the header

  /// The first field of one of these names, or nullptr.
  const PcdField* find(const std::vector<std::string>& names) const;
};

/// Parses a PCD 0.6 or 0.7 header. Throws InputError with the line.
PcdHeader parsePcdHeader(std::string_view content, const std::string& name);

}  // namespace scan_to_path::scan
