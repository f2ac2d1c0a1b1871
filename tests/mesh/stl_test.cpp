// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "scan_to_path/mesh/read_mesh.h"
#include "support/expect_input_error.h"
#include "support/mesh_text.h"
#include "support/meshes.h"

namespace scan_to_path::mesh {
namespace {

using test::expectInputError;

TEST(Stl, MayHoldSeveralSolidsAndNegativeZeros) {
  const auto solid = [](const std::string& first) {
    return "solid a\nfacet normal nan nan nan\nouter loop\nvertex " + first +
           "\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
  };
  const MeshFile file = parseMesh(solid("0 0 0") + solid("-0.0 0 -0"), "f.stl");
  EXPECT_EQ(file.mesh.vertices.size(), 3U);
  EXPECT_EQ(file.mesh.triangles.size(), 2U);
}

TEST(Stl, ErrorsNameTheLineOrByte) {
  const std::string start = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  expectInputError([&] { parseMesh(start, "f.stl"); }, "f.stl line 5: word is the end of the file");
  expectInputError([&] { parseMesh(start + "vertex 0 one 0\n", "f.stl"); }, "f.stl line 6: vertex y is 'one'");
  expectInputError([&] { parseMesh(start + "endloop\nendfacet\nendsolid\n", "f.stl"); }, "face's vertices is 2");
  expectInputError([&] { parseMesh("solid a\nfacet middle\n", "f.stl"); }, "word is 'middle', must be 'normal'");
  const std::string bytes = test::stlBytes(test::cubeMesh(1));
  expectInputError([&] { parseMesh(bytes.substr(0, 300), "f.stl"); },
                   "f.stl byte 80: number of triangles is 12, must be at most 4");
}

}  // namespace
}  // namespace scan_to_path::mesh
