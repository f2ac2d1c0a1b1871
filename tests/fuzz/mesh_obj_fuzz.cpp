// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "read_any_mesh.h"
#include "support/mesh_text.h"
#include "support/meshes.h"

std::vector<std::string> scan_to_path::fuzz::seeds() {
  return {test::objText(test::cubeMesh(0.5)),
          "v 0 0 0\nv 1 0 0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\nusemtl m\nf 1/1/1 2//1 3/1 4 # quad\nf -4 -3 -2\n"};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scan_to_path::fuzz::readAnyMesh(scan_to_path::fuzz::asText(data, size));
  return 0;
}
