// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/input.h"

#include <cstring>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/mesh/ply.h"

namespace scan_to_path::pipeline {
namespace {

constexpr double min_diagonal = 0.005;  // [m]
constexpr double max_diagonal = 20.0;   // [m]

bool startsWith(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

std::string_view firstLine(std::string_view content) { return trimmed(content.substr(0, content.find('\n'))); }

bool isPcd(std::string_view content) {
  return startsWith(content, "# .PCD") || startsWith(content, "VERSION ") || startsWith(content, "FIELDS ");
}

/// IGES fixes the letter in column 73 of every line to its section; the start section comes first.
bool isIges(std::string_view content) { return content.size() > 73 && content[72] == 'S' && content[73] == ' '; }

bool isCad(std::string_view content) {
  return startsWith(content, "ISO-10303-21") || startsWith(content, "DBRep_DrawableShape") ||
         startsWith(content, "CASCADE Topology") || isIges(content);
}

/// An 80-byte header, the number of triangles, and 50 bytes for each.
bool isBinaryStl(std::string_view content) {
  if (content.size() < 84) return false;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, content.data() + 80, sizeof(triangles));
  return content.size() == 84 + 50 * static_cast<std::size_t>(triangles);
}

bool isOff(std::string_view content) {
  const std::string_view line = firstLine(content);
  return line.find("OFF") != std::string_view::npos && line.size() <= 12;
}

/// The first line that is not blank or a comment begins with a word that Wavefront files begin with.
bool isObj(std::string_view content) {
  while (!content.empty()) {
    const std::string_view line = firstLine(content);
    if (!line.empty() && line.front() != '#') {
      for (const char* word : {"v ", "vn ", "vt ", "f ", "o ", "g ", "s ", "mtllib ", "usemtl "}) {
        if (startsWith(line, word)) return true;
      }
      return false;
    }
    const auto end = content.find('\n');
    content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
  }
  return false;
}

}  // namespace

double metresPerUnit(Units units) {
  switch (units) {
    case Units::mm: return 1e-3;
    case Units::inch: return 0.0254;
    case Units::m: break;
  }
  return 1.0;
}

InputKind detectInput(std::string_view content, const std::string& name) {
  if (content.empty()) throw InputError(name + ": is empty");
  if (startsWith(content, "#ROSBAG")) throw InputError(name + ": is a ROS bag; this build reads none, use the ROS build");
  if (startsWith(content, "# scan_to_path samples")) return InputKind::samples;
  if (isPcd(content)) return InputKind::cloud;
  if (mesh::isPly(content)) return mesh::parsePlyHeader(content, name).hasFaces() ? InputKind::mesh : InputKind::cloud;
  if (isCad(content)) return InputKind::cad;
  if (isBinaryStl(content) || startsWith(content, "solid") || isOff(content) || isObj(content)) return InputKind::mesh;
  throw InputError(name + ": is none of sample log, PCD, PLY, STL, OBJ, OFF, STEP, IGES, BREP; say which with --input-kind");
}

void checkPlausibleSize(const Eigen::AlignedBox3d& bounds, Units units, const std::string& name) {
  const double diagonal = bounds.diagonal().norm();
  if (diagonal >= min_diagonal && diagonal <= max_diagonal) return;
  std::string suggestion;
  for (const Units other : {Units::mm, Units::inch, Units::m}) {
    const double size = diagonal / metresPerUnit(units) * metresPerUnit(other);
    if (other != units && size >= min_diagonal && size <= max_diagonal) {
      suggestion += std::string(suggestion.empty() ? "; if the file is in " : " or ") + enumName(other) + " (" +
                    fixed(size, 3) + " m), say --units " + enumName(other);
    }
  }
  throw InputError(name + ": part measures " + fixed(diagonal, 6) + " m across, expected 0.005 m to 20 m" + suggestion +
                   (suggestion.empty() ? "; say --units to insist" : ""));
}

}  // namespace scan_to_path::pipeline
