// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstring>

#include "mesh_builder.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "text_cursor.h"

namespace scan_to_path::mesh {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

std::uint64_t hashOf(const Eigen::Vector3d& vertex) {
  std::uint64_t hash = 0;
  for (int i = 0; i < 3; ++i) {
    std::uint64_t bits;
    std::memcpy(&bits, &vertex[i], sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Gives equal vertices the same index, in order of first appearance: an open-addressing hash table.
class Welder {
public:
  template <class Where>
  std::int64_t indexOf(Eigen::Vector3d vertex, MeshBuilder& builder, const Where& where) {
    vertex.array() += 0.0;  // -0 and 0 are the same place
    if (2 * (vertices_.size() + 1) > slots_.size()) grow();
    std::size_t slot = slotOf(vertex);
    if (slots_[slot] == empty) {
      builder.addVertex(vertex, where);
      slots_[slot] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(vertex);
    }
    return slots_[slot];
  }

private:
  static constexpr std::uint32_t empty = 0xffffffffU;

  /// The slot that holds the vertex, or the empty one where it belongs.
  std::size_t slotOf(const Eigen::Vector3d& vertex) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hashOf(vertex) & mask;
    while (slots_[slot] != empty && vertices_[slots_[slot]] != vertex) slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    slots_.assign(std::max<std::size_t>(1024, 2 * slots_.size()), empty);
    for (std::size_t i = 0; i < vertices_.size(); ++i) slots_[slotOf(vertices_[i])] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> slots_;
  std::vector<Eigen::Vector3d> vertices_;
};

/// Words of the whole text, with the line they stand on.
class WordReader {
public:
  WordReader(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  /// The next word; empty at the end of the file.
  std::string_view next() {
    std::string_view word = takeWord(line_);
    while (word.empty() && !rest_.empty()) {
      line_ = takeLine(rest_);
      ++line_number_;
      word = takeWord(line_);
    }
    return word;
  }

  void skipLine() { line_ = {}; }

  void expect(std::string_view wanted) {
    const std::string_view word = next();
    if (word != wanted) throw InputError(where(), "word", wordText(word), inQuotes(wanted));
  }

  double number(const char* quantity) {
    const std::string_view word = next();
    double value = 0.0;
    if (!parseNumber(word, value)) throw InputError(where(), quantity, wordText(word), "a number");
    return value;
  }

  std::string where() const { return name_ + " line " + std::to_string(line_number_); }

  static std::string wordText(std::string_view word) { return word.empty() ? "the end of the file" : inQuotes(word); }

private:
  std::string_view rest_;
  std::string name_;
  std::string_view line_;
  std::size_t line_number_ = 0;
};

void readFacet(WordReader& words, Welder& welder, MeshBuilder& builder) {
  const auto where = [&] { return words.where(); };
  words.expect("normal");
  for (int i = 0; i < 3; ++i) words.next();  // the vertices' order says it, and many writers leave it zero or nan
  words.expect("outer");
  words.expect("loop");
  std::vector<std::int64_t> indices;
  std::string_view word = words.next();
  for (; word == "vertex"; word = words.next()) {
    const double x = words.number("vertex x");
    const double y = words.number("vertex y");
    const double z = words.number("vertex z");
    indices.push_back(welder.indexOf({x, y, z}, builder, where));
  }
  if (word != "endloop") throw InputError(words.where(), "word", WordReader::wordText(word), "'vertex' or 'endloop'");
  words.expect("endfacet");
  builder.addPolygon(indices, where);
}

/// Byte by byte: the file is little-endian whatever the machine is.
std::uint32_t littleEndian(std::string_view content, std::size_t position) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(content[position + i]);
  return value;
}

std::uint32_t triangleCount(std::string_view content) { return littleEndian(content, header_bytes - 4); }

float floatAt(std::string_view content, std::size_t position) {
  const std::uint32_t bits = littleEndian(content, position);
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

Eigen::Vector3d vertexAt(std::string_view content, std::size_t position) {
  return {floatAt(content, position), floatAt(content, position + 4), floatAt(content, position + 8)};
}

}  // namespace

bool looksLikeStlAscii(std::string_view content) {
  const std::string_view start = trimmed(content.substr(0, 4096));
  return start.substr(0, 5) == "solid" && start.find('\0') == std::string_view::npos &&
         (start.find("facet") != std::string_view::npos || start.find("endsolid") != std::string_view::npos);
}

bool looksLikeStlBinary(std::string_view content) {
  if (content.size() < header_bytes) return false;
  const std::size_t bytes = header_bytes + triangle_bytes * std::size_t{triangleCount(content)};
  if (bytes == content.size()) return true;
  // A truncated one: the first triangle is plausible, and nothing else that is known has zeros in its first lines.
  if (content.size() < header_bytes + triangle_bytes || bytes < content.size()) return false;
  if (content.substr(0, header_bytes).find('\0') == std::string_view::npos) return false;
  bool is_plausible = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d vertex = vertexAt(content, header_bytes + 12 * i);
    is_plausible = is_plausible && vertex.lpNorm<Eigen::Infinity>() < 1e9;
  }
  return is_plausible;
}

MeshFile parseStlAscii(std::string_view content, const std::string& name) {
  WordReader words(content, name);
  Welder welder;
  MeshBuilder builder;
  bool is_inside = false;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (is_inside && word == "facet") {
      readFacet(words, welder, builder);
    } else if (word == (is_inside ? "endsolid" : "solid")) {
      is_inside = !is_inside;
      words.skipLine();  // the solid's name
    } else {
      throw InputError(words.where(), "word", inQuotes(word), is_inside ? "'facet' or 'endsolid'" : "'solid'");
    }
  }
  if (is_inside) throw InputError(words.where() + ": file ends without endsolid");
  return builder.finish(MeshFormat::stl_ascii, name);
}

MeshFile parseStlBinary(std::string_view content, const std::string& name) {
  const std::size_t count = triangleCount(content);
  const std::size_t room = (content.size() - header_bytes) / triangle_bytes;
  if (count > room) {
    throw InputError(name + " byte 80", "number of triangles", std::to_string(count),
                     "at most " + std::to_string(room) + ", all that the file's " + std::to_string(content.size()) +
                         " bytes have room for (truncated?)");
  }
  Welder welder;
  MeshBuilder builder;
  std::vector<std::int64_t> indices(3);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t start = header_bytes + triangle_bytes * i;
    const auto where = [&] { return name + " triangle " + std::to_string(i) + " byte " + std::to_string(start); };
    for (std::size_t k = 0; k < 3; ++k) {
      indices[k] = welder.indexOf(vertexAt(content, start + 12 * (k + 1)), builder, where);
    }
    builder.addPolygon(indices, where);
  }
  return builder.finish(MeshFormat::stl_binary, name);
}

}  // namespace scan_to_path::mesh
