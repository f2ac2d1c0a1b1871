// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>

#include "scan_to_path/mesh/triangle_mesh.h"

namespace scan_to_path::test {

/// Meshes as files of the formats that the package only reads; written apart from any reader's code.
inline std::string objText(const mesh::TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "# test\no part\n";
  for (const auto& v : mesh.vertices) text << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
  for (const auto& t : mesh.triangles) text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
  return text.str();
}

inline std::string offText(const mesh::TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << mesh.vertices.size() << " " << mesh.triangles.size() << " 0\n";
  for (const auto& v : mesh.vertices) text << v.x() << " " << v.y() << " " << v.z() << "\n";
  for (const auto& t : mesh.triangles) text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  return text.str();
}

inline std::string stlText(const mesh::TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "solid test part\n";
  for (const auto& t : mesh.triangles) {
    text << " facet normal 0 0 0\n  outer loop\n";
    for (const auto i : t) {
      const auto& v = mesh.vertices[i];
      text << "   vertex " << v.x() << " " << v.y() << " " << v.z() << "\n";
    }
    text << "  endloop\n endfacet\n";
  }
  text << "endsolid test part\n";
  return text.str();
}

/// Coordinates are rounded to float, as the format has it.
inline std::string stlBytes(const mesh::TriangleMesh& mesh) {
  std::string bytes(80, '\0');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  const auto append = [&bytes](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  };
  append(&count, 4);
  for (const auto& t : mesh.triangles) {
    bytes.append(12, '\0');
    for (const auto i : t) {
      const Eigen::Vector3f v = mesh.vertices[i].cast<float>();
      append(v.data(), 12);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace scan_to_path::test
