// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scan_to_path::mesh {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of the value, or of a list's entries
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list's length; always an integer type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< rows, as the header says
  std::vector<PlyProperty> properties;

  /// Index of the property, or nothing.
  std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;  ///< in file order
  std::size_t bytes = 0;             ///< of the header; the body starts there
  std::size_t lines = 0;             ///< of the header

  /// The element, or nullptr.
  const PlyElement* find(std::string_view element) const;
  /// True with at least one face: a mesh. Otherwise it is a cloud.
  bool hasFaces() const;
};

/// True when the content starts as a PLY file does.
bool isPly(std::string_view content);

/// Parses the header. `name` stands in messages. Throws InputError with the line.
PlyHeader parsePlyHeader(std::string_view content, const std::string& name);

/// One row of an element, reused from row to row.
struct PlyRow {
  std::vector<double> values;              ///< one per property; a list's length stands for the list
  std::vector<std::vector<double>> lists;  ///< one per property; empty for a scalar
};

/// Reads a PLY body (Turk 1994; ascii, binary in both byte orders) element by element and row by row:
///
///     PlyReader reader(content, name);
///     PlyRow row;
///     while (const PlyElement* element = reader.nextElement()) {
///       if (element->name != "vertex") continue;
///       for (std::uint64_t i = 0; i < element->count; ++i) reader.readRow(row);
///     }
///
/// Row counts are checked against the bytes that are there when an element starts, so a caller may reserve `count`
/// rows. NaN and infinities are passed on: the caller knows which values matter. Throws InputError with the line
/// (ascii) or byte offset (binary) for a truncated or malformed file.
class PlyReader {
public:
  /// The content must outlive the reader.
  PlyReader(std::string_view content, std::string name);

  const PlyHeader& header() const { return header_; }

  /// Goes on to the next element, past rows of the current one that were not read; nullptr after the last.
  const PlyElement* nextElement();

  /// Reads the next row of the current element. Precondition: not all of them have been read.
  void readRow(PlyRow& row);

  /// File and place of the row read last, "part.ply line 17" or "part.ply byte 4032", for messages.
  std::string where() const;

private:
  const PlyElement& current() const { return header_.elements[next_element_ - 1]; }
  void checkRoom(const PlyElement& element) const;
  void skipRows();
  void readAsciiRow(PlyRow& row);
  void readBinaryRow(PlyRow& row);
  double readBinary(PlyType type);
  std::size_t listLength(double length, std::size_t room) const;

  std::string_view content_;
  std::string name_;
  PlyHeader header_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  std::size_t row_start_ = 0;
  std::size_t next_element_ = 0;
  std::uint64_t rows_left_ = 0;
};

}  // namespace scan_to_path::mesh
