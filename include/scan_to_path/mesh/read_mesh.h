// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "scan_to_path/mesh/ply.h"
#include "scan_to_path/mesh/triangle_mesh.h"

namespace scan_to_path::mesh {

/// What a file's content says it is; its name does not matter.
enum class MeshFormat { none, ply, stl_ascii, stl_binary, obj, off };

/// none for anything that is not a mesh, and for a PLY file without faces, which is a cloud.
MeshFormat probeMesh(std::string_view content);

/// "PLY", "STL" and so on, for reports.
const char* meshFormatName(MeshFormat format);

/// A mesh and what became of the file's faces.
struct MeshFile {
  TriangleMesh mesh;  ///< in the file's own unit
  MeshFormat format = MeshFormat::none;
  std::size_t faces = 0;               ///< in the file, polygons counted once
  std::size_t dropped_degenerate = 0;  ///< triangles without an area, left out
};

/// Reads PLY (ascii and binary), STL (ascii and binary; equal vertices become one), OBJ (v and f) or OFF (ascii).
/// Polygons are cut into fans from their first vertex. Throws InputError with file and line or byte for anything
/// malformed: coordinates that are not finite or beyond 1e9, indices out of range, truncation, no triangles.
MeshFile readMesh(const std::filesystem::path& file);

/// The same from memory; `name` stands in messages.
MeshFile parseMesh(std::string_view content, const std::string& name);

/// The mesh as a PLY file. Coordinates are doubles and read back the same to the last bit.
std::string formatPly(const TriangleMesh& mesh, PlyFormat format = PlyFormat::binary_little_endian);

}  // namespace scan_to_path::mesh
