// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "text_cursor.h"

namespace scan_to_path::mesh {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> type_names = {{{"char", PlyType::int8},
                                                  {"int8", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"uint8", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"int16", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"int32", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"float32", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"float64", PlyType::float64}}};

constexpr std::size_t typeBytes(PlyType type) {
  constexpr std::array<std::size_t, 8> bytes = {1, 1, 2, 2, 4, 4, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

PlyType parseType(std::string_view word, const std::string& where) {
  const auto found =
      std::find_if(type_names.begin(), type_names.end(), [word](const TypeName& entry) { return entry.name == word; });
  if (found == type_names.end()) throw InputError(where, "property type", inQuotes(word), "a PLY type such as float");
  return found->type;
}

PlyFormat parseFormat(std::string_view line, const std::string& where) {
  const std::string_view word = takeWord(line);
  if (word == "ascii") return PlyFormat::ascii;
  if (word == "binary_little_endian") return PlyFormat::binary_little_endian;
  if (word == "binary_big_endian") return PlyFormat::binary_big_endian;
  throw InputError(where, "format", inQuotes(word), "ascii, binary_little_endian or binary_big_endian");
}

PlyElement parseElement(std::string_view line, const std::string& where) {
  PlyElement element;
  element.name = takeWord(line);
  const double count = takeNumber(
      line, [&] { return where; }, "element count");
  constexpr double largest = 9007199254740992.0;  // 2^53: exact as a double
  if (!(count >= 0.0 && count <= largest) || count != std::floor(count)) {
    throw InputError(where, "element count", fixed(count, 0), "a whole number from 0 to 2^53");
  }
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

PlyProperty parseProperty(std::string_view line, const std::string& where) {
  PlyProperty property;
  std::string_view word = takeWord(line);
  property.is_list = word == "list";
  if (property.is_list) {
    property.count_type = parseType(takeWord(line), where);
    if (property.count_type >= PlyType::float32) {
      throw InputError(where, "list length type", "a floating-point type", "an integer type");
    }
    word = takeWord(line);
  }
  property.type = parseType(word, where);
  property.name = takeWord(line);
  if (property.name.empty()) throw InputError(where, "property name", "missing", "a word");
  return property;
}

/// Parses one header line; false at its end.
bool parseHeaderLine(std::string_view line, const std::string& where, PlyHeader& header, bool& has_format) {
  const std::string_view keyword = takeWord(line);
  if (keyword == "end_header") return false;
  if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
  if (keyword == "format") {
    header.format = parseFormat(line, where);
    has_format = true;
  } else if (keyword == "element") {
    header.elements.push_back(parseElement(line, where));
  } else if (keyword == "property" && !header.elements.empty()) {
    header.elements.back().properties.push_back(parseProperty(line, where));
  } else {
    throw InputError(where, "header line", inQuotes(keyword), "format, element, property, comment or end_header");
  }
  return true;
}

/// Fewest bytes a row can take: in ascii a digit and a separator per property.
std::size_t leastRowBytes(const PlyElement& element, PlyFormat format) {
  std::size_t bytes = 0;
  for (const auto& property : element.properties) {
    bytes += format == PlyFormat::ascii ? 2 : typeBytes(property.is_list ? property.count_type : property.type);
  }
  return bytes;
}

template <class T>
double decode(const char* bytes, bool swapped) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (swapped) std::reverse(raw.begin(), raw.end());
  T value;
  std::memcpy(&value, raw.data(), sizeof(T));
  return static_cast<double>(value);
}

double decode(PlyType type, const char* bytes, bool swapped) {
  switch (type) {
    case PlyType::int8:
      return decode<std::int8_t>(bytes, swapped);
    case PlyType::uint8:
      return decode<std::uint8_t>(bytes, swapped);
    case PlyType::int16:
      return decode<std::int16_t>(bytes, swapped);
    case PlyType::uint16:
      return decode<std::uint16_t>(bytes, swapped);
    case PlyType::int32:
      return decode<std::int32_t>(bytes, swapped);
    case PlyType::uint32:
      return decode<std::uint32_t>(bytes, swapped);
    case PlyType::float32:
      return decode<float>(bytes, swapped);
    default:
      return decode<double>(bytes, swapped);
  }
}

void shapeRow(PlyRow& row, std::size_t properties) {
  row.values.resize(properties);
  row.lists.resize(properties);
  for (auto& list : row.lists) list.clear();
}

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return i;
  }
  return std::nullopt;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  for (const auto& candidate : elements) {
    if (candidate.name == element) return &candidate;
  }
  return nullptr;
}

bool PlyHeader::hasFaces() const {
  const PlyElement* face = find("face");
  return face != nullptr && face->count > 0;
}

bool isPly(std::string_view content) {
  return content.substr(0, 3) == "ply" && content.size() > 3 && (content[3] == '\n' || content[3] == '\r');
}

PlyHeader parsePlyHeader(std::string_view content, const std::string& name) {
  if (!isPly(content)) throw InputError(name + " line 1", "first line", inQuotes(content.substr(0, 10)), "ply");
  PlyHeader header;
  std::string_view rest = content;
  takeLine(rest);
  header.lines = 1;
  bool has_format = false;
  bool in_header = true;
  while (in_header) {
    if (rest.empty()) throw InputError(name + ": PLY header has no end_header line");
    const std::string_view line = takeLine(rest);
    ++header.lines;
    in_header = parseHeaderLine(line, name + " line " + std::to_string(header.lines), header, has_format);
  }
  if (!has_format) throw InputError(name + ": PLY header has no format line");
  header.bytes = content.size() - rest.size();
  return header;
}

PlyReader::PlyReader(std::string_view content, std::string name)
    : content_(content),
      name_(std::move(name)),
      header_(parsePlyHeader(content, name_)),
      position_(header_.bytes),
      line_(header_.lines) {}

std::string PlyReader::where() const {
  return header_.format == PlyFormat::ascii ? name_ + " line " + std::to_string(line_)
                                            : name_ + " byte " + std::to_string(row_start_);
}

const PlyElement* PlyReader::nextElement() {
  skipRows();
  if (next_element_ == header_.elements.size()) return nullptr;
  const PlyElement& element = header_.elements[next_element_];
  checkRoom(element);
  ++next_element_;
  rows_left_ = element.count;
  return &element;
}

void PlyReader::checkRoom(const PlyElement& element) const {
  if (element.count == 0) return;
  const std::size_t row = leastRowBytes(element, header_.format);
  // The last line of an ascii file may lack its end.
  const std::size_t room = content_.size() - position_ + (header_.format == PlyFormat::ascii ? 1 : 0);
  if (row != 0 && element.count <= room / row) return;
  if (row == 0) throw InputError(name_ + ": element " + inQuotes(element.name) + " has rows but no properties");
  throw InputError(name_ + " element " + inQuotes(element.name), "row count", std::to_string(element.count),
                   "at most " + std::to_string(room / row) + ", all that the file's " +
                       std::to_string(content_.size()) + " bytes have room for (truncated?)");
}

void PlyReader::skipRows() {
  if (rows_left_ == 0) return;
  const auto& properties = current().properties;
  const bool is_fixed = std::none_of(properties.begin(), properties.end(), [](const auto& p) { return p.is_list; });
  if (header_.format != PlyFormat::ascii && is_fixed) {
    position_ += static_cast<std::size_t>(rows_left_) * leastRowBytes(current(), header_.format);
    rows_left_ = 0;
  }
  PlyRow row;
  while (rows_left_ > 0) readRow(row);
}

void PlyReader::readRow(PlyRow& row) {
  shapeRow(row, current().properties.size());
  row_start_ = position_;
  --rows_left_;
  if (header_.format == PlyFormat::ascii) {
    readAsciiRow(row);
  } else {
    readBinaryRow(row);
  }
}

std::size_t PlyReader::listLength(double length, std::size_t room) const {
  if (!(length >= 0.0 && length <= static_cast<double>(room)) || length != std::floor(length)) {
    throw InputError(where(), "list length", fixed(length, 0),
                     "a whole number from 0 to " + std::to_string(room) + ", all that there is room for");
  }
  return static_cast<std::size_t>(length);
}

void PlyReader::readAsciiRow(PlyRow& row) {
  std::string_view line;
  do {
    if (position_ >= content_.size()) {
      throw InputError(where() + ": file ends " + std::to_string(rows_left_ + 1) + " rows before the end of element " +
                       inQuotes(current().name));
    }
    std::string_view rest = content_.substr(position_);
    line = trimmed(takeLine(rest));
    position_ = content_.size() - rest.size();
    ++line_;
  } while (line.empty());
  const auto& properties = current().properties;
  const auto take = [&](const PlyProperty& property) {
    return takeNumber(
        line, [this] { return where(); }, property.name.c_str());
  };
  for (std::size_t i = 0; i < properties.size(); ++i) {
    row.values[i] = take(properties[i]);
    if (!properties[i].is_list) continue;
    const std::size_t length = listLength(row.values[i], (line.size() + 1) / 2);
    for (std::size_t k = 0; k < length; ++k) row.lists[i].push_back(take(properties[i]));
  }
  if (!trimmed(line).empty()) {
    throw InputError(where(), "end of row", inQuotes(trimmed(line)),
                     "empty after the " + std::to_string(properties.size()) + " properties");
  }
}

double PlyReader::readBinary(PlyType type) {
  const std::size_t bytes = typeBytes(type);
  if (content_.size() - position_ < bytes) {
    throw InputError(where() + ": file ends at byte " + std::to_string(content_.size()) + ", " +
                     std::to_string(rows_left_ + 1) + " rows before the end of element " + inQuotes(current().name));
  }
  const double value = decode(type, content_.data() + position_, header_.format == PlyFormat::binary_big_endian);
  position_ += bytes;
  return value;
}

void PlyReader::readBinaryRow(PlyRow& row) {
  const auto& properties = current().properties;
  for (std::size_t i = 0; i < properties.size(); ++i) {
    const PlyProperty& property = properties[i];
    row.values[i] = readBinary(property.is_list ? property.count_type : property.type);
    if (!property.is_list) continue;
    const std::size_t length = listLength(row.values[i], (content_.size() - position_) / typeBytes(property.type));
    for (std::size_t k = 0; k < length; ++k) row.lists[i].push_back(readBinary(property.type));
  }
}

}  // namespace scan_to_path::mesh
