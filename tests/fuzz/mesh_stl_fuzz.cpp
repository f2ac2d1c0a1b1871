// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "read_any_mesh.h"
#include "support/mesh_text.h"
#include "support/meshes.h"

std::vector<std::string> scan_to_path::fuzz::seeds() {
  return {test::stlText(test::cubeMesh(0.5)), test::stlBytes(test::cubeMesh(0.5))};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scan_to_path::fuzz::readAnyMesh(scan_to_path::fuzz::asText(data, size));
  return 0;
}
