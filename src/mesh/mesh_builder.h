// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scan_to_path/mesh/read_mesh.h"

namespace scan_to_path::mesh {

/// Collects what the readers of all formats find, with the checks that they share. `where()` gives the place in the
/// file as text; it is asked only when something is wrong.
class MeshBuilder {
public:
  /// Throws InputError unless the coordinates are finite and within 1e9.
  template <class Where>
  void addVertex(const Eigen::Vector3d& vertex, const Where& where) {
    if (!isPlausible(vertex)) refuseVertex(vertex, where());
    result_.mesh.vertices.push_back(vertex);
  }

  /// Adds a polygon of vertices added before, counted from 0. Throws InputError when an index is out of range or
  /// there are fewer than three.
  template <class Where>
  void addPolygon(const std::vector<std::int64_t>& indices, const Where& where) {
    if (!isPolygon(indices)) refusePolygon(indices, where());
    appendFan(indices);
  }

  std::size_t vertexCount() const { return result_.mesh.vertices.size(); }

  /// Drops degenerate triangles. Throws InputError when no triangle is left.
  MeshFile finish(MeshFormat format, const std::string& name);

private:
  bool isPlausible(const Eigen::Vector3d& vertex) const;
  bool isPolygon(const std::vector<std::int64_t>& indices) const;
  [[noreturn]] void refuseVertex(const Eigen::Vector3d& vertex, const std::string& where) const;
  [[noreturn]] void refusePolygon(const std::vector<std::int64_t>& indices, const std::string& where) const;
  void appendFan(const std::vector<std::int64_t>& indices);

  MeshFile result_;
};

MeshFile parsePlyMesh(std::string_view content, const std::string& name);
MeshFile parseStlAscii(std::string_view content, const std::string& name);
MeshFile parseStlBinary(std::string_view content, const std::string& name);
MeshFile parseObj(std::string_view content, const std::string& name);
MeshFile parseOff(std::string_view content, const std::string& name);

bool looksLikeStlAscii(std::string_view content);
bool looksLikeStlBinary(std::string_view content);
bool looksLikeObj(std::string_view content);
bool looksLikeOff(std::string_view content);

}  // namespace scan_to_path::mesh
