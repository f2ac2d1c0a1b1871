// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "read_any_mesh.h"
#include "support/mesh_text.h"
#include "support/meshes.h"

std::vector<std::string> scan_to_path::fuzz::seeds() {
  return {test::offText(test::cubeMesh(0.5)), "COFF 4 1 0\n0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n4 0 1 2 3 0.5\n"};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scan_to_path::fuzz::readAnyMesh(scan_to_path::fuzz::asText(data, size));
  return 0;
}
