// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "scan_to_path/mesh/read_mesh.h"
#include "support/expect_input_error.h"

namespace scan_to_path::mesh {
namespace {

using test::expectInputError;

TEST(Obj, CornersMayHaveSlashesAndNegativeIndices) {
  const char* const text =
      "mtllib a.mtl\nv 0 0 0 1 1 1\nv 1 0 0\nvt 0 0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\ng quad\nusemtl red\ns off\n"
      "f 1/1/1 2//1 3/1 4 # a comment\nf -4 -3 -2\n";
  const MeshFile file = parseMesh(text, "f.obj");
  EXPECT_EQ(file.faces, 2U);
  EXPECT_EQ(file.mesh.triangles.size(), 3U);
  EXPECT_DOUBLE_EQ(file.mesh.area(), 1.5);
}

TEST(Obj, ErrorsNameTheLine) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expectInputError([&] { parseMesh(vertices + "f 1 2 4\n", "f.obj"); }, "f.obj line 4: vertex index");
  expectInputError([&] { parseMesh(vertices + "f 1 2 -4\n", "f.obj"); }, "is -1");
  expectInputError([&] { parseMesh(vertices + "f 1 2 0\n", "f.obj"); }, "face corner is '0'");
  expectInputError([&] { parseMesh(vertices + "f 1 2 x\n", "f.obj"); }, "face corner is 'x'");
  expectInputError([&] { parseMesh(vertices + "f 1 2\n", "f.obj"); }, "vertices is 2, must be at least 3");
  expectInputError([&] { parseMesh(vertices + "v 1 2\n", "f.obj"); }, "line 4: vertex coordinate is missing");
  expectInputError([&] { parseMesh(vertices + "surf 1 2\n", "f.obj"); }, "line 4: statement is 'surf'");
}

}  // namespace
}  // namespace scan_to_path::mesh
