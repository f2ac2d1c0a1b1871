// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "read_any_mesh.h"
#include "support/mesh_text.h"
#include "support/meshes.h"

std::vector<std::string> scan_to_path::fuzz::seeds() {
  const mesh::TriangleMesh cube = test::cubeMesh(0.5);
  return {mesh::formatPly(cube, mesh::PlyFormat::ascii), mesh::formatPly(cube, mesh::PlyFormat::binary_little_endian),
          mesh::formatPly(cube, mesh::PlyFormat::binary_big_endian),
          "ply\nformat ascii 1.0\nelement extra 1\nproperty list uint8 float w\nelement vertex 3\nproperty float x\n"
          "property uchar red\nproperty double y\nproperty short z\nelement face 1\n"
          "property list int int vertex_index\nend_header\n2 1 1\n0 1 0 0\n1 2 0 0\n0 3 1 0\n3 0 1 2\n"};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scan_to_path::fuzz::readAnyMesh(scan_to_path::fuzz::asText(data, size));
  return 0;
}
