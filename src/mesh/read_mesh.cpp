// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/read_mesh.h"

#include "mesh_builder.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::mesh {
namespace {

/// A PLY file with a broken header is a mesh to be refused by name rather than a file of no known kind.
bool isPlyCloud(std::string_view content) {
  try {
    return !parsePlyHeader(content, "").hasFaces();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

MeshFormat probeMesh(std::string_view content) {
  if (isPly(content)) return isPlyCloud(content) ? MeshFormat::none : MeshFormat::ply;
  if (looksLikeOff(content)) return MeshFormat::off;
  if (looksLikeStlAscii(content)) return MeshFormat::stl_ascii;
  if (looksLikeStlBinary(content)) return MeshFormat::stl_binary;
  if (looksLikeObj(content)) return MeshFormat::obj;
  return MeshFormat::none;
}

const char* meshFormatName(MeshFormat format) {
  switch (format) {
    case MeshFormat::ply:
      return "PLY";
    case MeshFormat::stl_ascii:
      return "STL (ascii)";
    case MeshFormat::stl_binary:
      return "STL (binary)";
    case MeshFormat::obj:
      return "OBJ";
    case MeshFormat::off:
      return "OFF";
    default:
      return "none";
  }
}

MeshFile parseMesh(std::string_view content, const std::string& name) {
  switch (probeMesh(content)) {
    case MeshFormat::ply:
      return parsePlyMesh(content, name);
    case MeshFormat::stl_ascii:
      return parseStlAscii(content, name);
    case MeshFormat::stl_binary:
      return parseStlBinary(content, name);
    case MeshFormat::obj:
      return parseObj(content, name);
    case MeshFormat::off:
      return parseOff(content, name);
    default:
      break;
  }
  if (content.empty()) throw InputError(name + ": file is empty");
  if (isPly(content)) throw InputError(name + ": PLY file has no faces: a cloud, not a mesh");
  throw InputError(name + ": content is not a PLY, STL, OBJ or OFF mesh");
}

MeshFile readMesh(const std::filesystem::path& file) { return parseMesh(readFile(file), file.string()); }

}  // namespace scan_to_path::mesh
