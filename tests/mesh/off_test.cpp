// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "scan_to_path/mesh/read_mesh.h"
#include "support/expect_input_error.h"

namespace scan_to_path::mesh {
namespace {

using test::expectInputError;

TEST(Off, MayHaveColoursCommentsAndCountsOnTheFirstLine) {
  const char* const text =
      "COFF 4 1 0 # counts\n\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n1 1 0 0 0 0 0\n0 1 0 0 0 0 0\n4 0 1 2 3 0.1 0.2 0.3\n";
  const MeshFile file = parseMesh(text, "f.off");
  EXPECT_EQ(file.mesh.triangles.size(), 2U);
  EXPECT_DOUBLE_EQ(file.mesh.area(), 1.0);
}

TEST(Off, ErrorsNameTheLine) {
  expectInputError([] { parseMesh("OFF BINARY\n", "f.off"); }, "OFF encoding is BINARY");
  expectInputError([] { parseMesh("OFF\n", "f.off"); }, "f.off line 1: file ends where the numbers");
  expectInputError([] { parseMesh("OFF\n4000000000 1 0\n", "f.off"); }, "number of vertices is 4000000000");
  expectInputError([] { parseMesh("OFF\n-1 1 0\n", "f.off"); }, "number of vertices is -1");
  expectInputError([] { parseMesh("OFF\n1 0 0\n0 0\n", "f.off"); }, "line 3: vertex coordinate is missing");
  expectInputError([] { parseMesh("OFF\n1 1 0\n0 0 0\n1000000000000 0 0\n", "f.off"); }, "vertex index is missing");
  expectInputError([] { parseMesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "f.off"); }, "is 3, must be below 3");
}

}  // namespace
}  // namespace scan_to_path::mesh
