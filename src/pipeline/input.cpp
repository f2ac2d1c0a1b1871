// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/input.h"

#include "scan_to_path/common/byte_order_mark.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/mesh/ply.h"
#include "scan_to_path/mesh/read_mesh.h"
#include "scan_to_path/scan/cloud_io.h"

namespace scan_to_path::pipeline {
namespace {

constexpr double min_diagonal = 0.005;  // [m]
constexpr double max_diagonal = 20.0;   // [m]

bool startsWith(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

/// IGES fixes the letter in column 73 of every line to its section; the start section comes first.
bool isIges(std::string_view content) { return content.size() > 73 && content[72] == 'S' && content[73] == ' '; }

bool isCad(std::string_view content) {
  return startsWith(content, "ISO-10303-21") || startsWith(content, "DBRep_DrawableShape") ||
         startsWith(content, "CASCADE Topology") || isIges(content);
}

}  // namespace

double metresPerUnit(Units units) {
  switch (units) {
    case Units::mm:
      return 1e-3;
    case Units::inch:
      return 0.0254;
    case Units::m:
      break;
  }
  return 1.0;
}

InputKind detectInput(std::string_view content, const std::string& name) {
  content = withoutByteOrderMark(content);
  if (content.empty()) throw InputError(name + ": is empty");
  if (startsWith(content, "#ROSBAG"))
    throw InputError(name + ": is a ROS bag; this build reads none, use the ROS build");
  if (startsWith(content, "# scan_to_path samples")) return InputKind::samples;
  if (scan::isPcd(content)) return InputKind::cloud;
  if (mesh::isPly(content)) return mesh::parsePlyHeader(content, name).hasFaces() ? InputKind::mesh : InputKind::cloud;
  if (isCad(content)) return InputKind::cad;
  if (mesh::probeMesh(content) != mesh::MeshFormat::none) return InputKind::mesh;
  throw InputError(name +
                   ": is none of sample log, PCD, PLY, STL, OBJ, OFF, STEP, IGES, BREP; say which with --input-kind");
}

void checkPlausibleSize(const Eigen::AlignedBox3d& bounds, Units units, const std::string& name,
                        const std::string& flag) {
  const double diagonal = bounds.diagonal().norm();
  if (diagonal >= min_diagonal && diagonal <= max_diagonal) return;
  std::string suggestion;
  for (const Units other : {Units::mm, Units::inch, Units::m}) {
    const double size = diagonal / metresPerUnit(units) * metresPerUnit(other);
    if (other != units && size >= min_diagonal && size <= max_diagonal) {
      suggestion += std::string(suggestion.empty() ? "; if the file is in " : " or ") + enumName(other) + " (" +
                    fixed(size, 3) + " m), say " + flag + " " + enumName(other);
    }
  }
  throw InputError(name + ": part measures " + fixed(diagonal, 6) + " m across, expected 0.005 m to 20 m" + suggestion +
                   (suggestion.empty() ? "; say " + flag + " to insist" : ""));
}

}  // namespace scan_to_path::pipeline
