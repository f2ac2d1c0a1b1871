// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "fuzz.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/mesh/read_mesh.h"

namespace scan_to_path::fuzz {

/// What every mesh reader promises: InputError, or a mesh of finite vertices with triangles that have valid corners.
inline void readAnyMesh(std::string_view content) {
  try {
    const mesh::MeshFile file = mesh::parseMesh(content, "fuzz");
    require(!file.mesh.triangles.empty(), "a mesh has a triangle");
    for (const auto& vertex : file.mesh.vertices) require(vertex.allFinite(), "vertices are finite");
    for (const auto& triangle : file.mesh.triangles) {
      for (const auto index : triangle) require(index < file.mesh.vertices.size(), "indices are in range");
    }
  } catch (const InputError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos, "a message is one line");
  }
}

}  // namespace scan_to_path::fuzz
