// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include "mesh_builder.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "text_cursor.h"

namespace scan_to_path::mesh {
namespace {

/// Lines that hold something, without comments.
class DataLines {
public:
  DataLines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  /// The next line. Throws InputError at the end of the file, saying what was to come.
  std::string_view next(const char* what) {
    std::string_view line;
    do {
      if (rest_.empty()) throw InputError(where() + ": file ends where " + what + " should follow");
      line = takeLine(rest_);
      line = trimmed(line.substr(0, line.find('#')));
      ++line_number_;
    } while (line.empty());
    return line;
  }

  std::string where() const { return name_ + " line " + std::to_string(line_number_); }
  std::size_t bytesLeft() const { return rest_.size(); }

private:
  std::string_view rest_;
  std::string name_;
  std::size_t line_number_ = 0;
};

/// A row needs a digit and a separator for each of at least three numbers.
std::size_t takeCount(std::string_view& line, const DataLines& lines, const char* quantity) {
  const auto where = [&] { return lines.where(); };
  const double count = takeNumber(line, where, quantity);
  const double room = static_cast<double>(lines.bytesLeft() / 6 + 1);
  if (!(count >= 0.0 && count <= room) || count != std::floor(count)) {
    throw InputError(where(), quantity, fixed(count, 0),
                     "a whole number from 0 to " + fixed(room, 0) + ", all that the file has room for (truncated?)");
  }
  return static_cast<std::size_t>(count);
}

std::int64_t takeInteger(std::string_view& line, const DataLines& lines, const char* quantity) {
  const double value = takeNumber(
      line, [&] { return lines.where(); }, quantity);
  if (!(std::abs(value) < 1e15) || value != std::floor(value)) {
    throw InputError(lines.where(), quantity, std::to_string(value), "a whole number");
  }
  return static_cast<std::int64_t>(value);
}

void readFace(DataLines& lines, std::vector<std::int64_t>& indices, MeshBuilder& builder) {
  std::string_view line = lines.next("a face");
  const std::int64_t corners = takeInteger(line, lines, "number of a face's vertices");
  indices.clear();
  // A count beyond the line's numbers ends at the first that is missing.
  for (std::int64_t k = 0; k < corners; ++k) indices.push_back(takeInteger(line, lines, "vertex index"));
  builder.addPolygon(indices, [&] { return lines.where(); });
}

/// The magic word: OFF after optional texture, colour and normal marks.
bool isOffWord(std::string_view word) {
  for (const std::string_view mark : {"ST", "C", "N"}) {
    if (word.substr(0, mark.size()) == mark) word.remove_prefix(mark.size());
  }
  return word == "OFF";
}

}  // namespace

bool looksLikeOff(std::string_view content) {
  std::string_view start = content.substr(0, 4096);
  while (!start.empty()) {
    std::string_view line = takeLine(start);
    line = line.substr(0, line.find('#'));
    const std::string_view word = takeWord(line);
    if (!word.empty()) return isOffWord(word);
  }
  return false;
}

MeshFile parseOff(std::string_view content, const std::string& name) {
  DataLines lines(content, name);
  const auto where = [&] { return lines.where(); };
  std::string_view line = lines.next("OFF");
  takeWord(line);
  // The counts may follow the word on its own line.
  if (trimmed(line).empty()) line = lines.next("the numbers of vertices and faces");
  if (trimmed(line) == "BINARY") throw InputError(where(), "OFF encoding", "BINARY", "text");
  const std::size_t vertices = takeCount(line, lines, "number of vertices");
  const std::size_t faces = takeCount(line, lines, "number of faces");
  MeshBuilder builder;
  for (std::size_t i = 0; i < vertices; ++i) {
    line = lines.next("a vertex");
    Eigen::Vector3d vertex;
    for (int k = 0; k < 3; ++k) vertex[k] = takeNumber(line, where, "vertex coordinate");
    builder.addVertex(vertex, where);
  }
  std::vector<std::int64_t> indices;
  for (std::size_t i = 0; i < faces; ++i) readFace(lines, indices, builder);
  return builder.finish(MeshFormat::off, name);
}

}  // namespace scan_to_path::mesh
