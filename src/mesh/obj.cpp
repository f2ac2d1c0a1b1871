// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "mesh_builder.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "text_cursor.h"

namespace scan_to_path::mesh {
namespace {

/// Statements that carry no shape of their own here: appearance, grouping, lines and points.
constexpr std::array<std::string_view, 14> passed_over = {"vt", "vn", "vp",     "g",      "o",   "s",      "mg",
                                                          "l",  "p",  "usemtl", "mtllib", "lod", "usemap", "maplib"};

bool isPassedOver(std::string_view keyword) {
  return std::find(passed_over.begin(), passed_over.end(), keyword) != passed_over.end();
}

std::string_view withoutComment(std::string_view line) { return line.substr(0, line.find('#')); }

/// Index of a face's corner "v", "v/vt", "v//vn" or "v/vt/vn", counted from 0; negative ones count from the end.
template <class Where>
std::int64_t cornerIndex(std::string_view corner, std::size_t vertices, const Where& where) {
  const std::string_view text = corner.substr(0, corner.find('/'));
  double index = 0.0;
  if (!parseNumber(text, index) || index != std::floor(index) || index == 0.0 || std::abs(index) > 1e15) {
    throw InputError(where(), "face corner", inQuotes(corner), "an index, 1 or more or negative, such as 7 or 7/1/2");
  }
  const auto whole = static_cast<std::int64_t>(index);
  return whole > 0 ? whole - 1 : static_cast<std::int64_t>(vertices) + whole;
}

}  // namespace

bool looksLikeObj(std::string_view content) {
  bool has_vertex = false;
  std::string_view rest = content;
  constexpr int lines_to_judge_by = 10000;  // comments and material names may come first
  for (int i = 0; i < lines_to_judge_by && !rest.empty() && !has_vertex; ++i) {
    std::string_view line = withoutComment(takeLine(rest));
    const std::string_view keyword = takeWord(line);
    has_vertex = keyword == "v";
    if (!keyword.empty() && !has_vertex && !isPassedOver(keyword)) return false;
  }
  return has_vertex;
}

MeshFile parseObj(std::string_view content, const std::string& name) {
  MeshBuilder builder;
  std::size_t line_number = 0;
  const auto where = [&] { return name + " line " + std::to_string(line_number); };
  std::vector<std::int64_t> indices;
  std::string_view rest = content;
  while (!rest.empty()) {
    std::string_view line = withoutComment(takeLine(rest));
    ++line_number;
    const std::string_view keyword = takeWord(line);
    if (keyword == "v") {
      Eigen::Vector3d vertex;
      for (int i = 0; i < 3; ++i) vertex[i] = takeNumber(line, where, "vertex coordinate");
      builder.addVertex(vertex, where);
    } else if (keyword == "f") {
      indices.clear();
      for (auto corner = takeWord(line); !corner.empty(); corner = takeWord(line)) {
        indices.push_back(cornerIndex(corner, builder.vertexCount(), where));
      }
      builder.addPolygon(indices, where);
    } else if (!keyword.empty() && !isPassedOver(keyword)) {
      throw InputError(where(), "statement", inQuotes(keyword), "v, f or one without a shape, such as vt, vn, g");
    }
  }
  return builder.finish(MeshFormat::obj, name);
}

}  // namespace scan_to_path::mesh
