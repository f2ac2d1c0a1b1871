// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "scan_to_path/mesh/read_mesh.h"
#include "support/expect_input_error.h"
#include "support/meshes.h"

namespace scan_to_path::mesh {
namespace {

using test::expectInputError;

TEST(PlyMesh, FacesMayBePolygonsWithOtherProperties) {
  const MeshFile file = parseMesh(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty uchar red\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_index\nproperty list uchar float texcoord\n"
      "property uchar flags\nend_header\n0 9 0 0\n1 9 0 0\n1 9 1 0\n0 9 1 0\n4 0 1 2 3 2 0.5 0.5 7\n",
      "f.ply");
  EXPECT_EQ(file.faces, 1U);
  EXPECT_EQ(file.mesh.triangles.size(), 2U);
  EXPECT_DOUBLE_EQ(file.mesh.area(), 1.0);
}

TEST(PlyMesh, ErrorsNameThePlace) {
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  expectInputError([&] { parseMesh(head + faces + "0 0\n1 0\n0 1\n3 0 1 2\n", "f.ply"); },
                   "f.ply: element 'vertex' has no number called z");
  const std::string good = head + "property float z\n" + faces + "0 0 0\n1 0 0\n0 1 0\n";
  expectInputError([&] { parseMesh(good + "3 0 1 3\n", "f.ply"); },
                   "f.ply line 13: vertex index (counted from 0) is 3, must be below 3");
  expectInputError([&] { parseMesh(good + "3 0 1 -1\n", "f.ply"); }, "is -1");
  expectInputError([&] { parseMesh(good + "3 0 1 1.5\n", "f.ply"); }, "vertex index is 1.5");
  expectInputError([&] { parseMesh(good + "2 0 1\n", "f.ply"); }, "number of a face's vertices is 2");
  expectInputError([&] { parseMesh(good + "3 0 1 nan\n", "f.ply"); }, "vertex index is nan");
}

TEST(PlyMesh, RoundTripIsExact) {
  TriangleMesh sheet = test::wavySheet(20);
  for (const auto format : {PlyFormat::ascii, PlyFormat::binary_little_endian, PlyFormat::binary_big_endian}) {
    const MeshFile file = parseMesh(formatPly(sheet, format), "sheet");
    EXPECT_EQ(file.mesh.vertices, sheet.vertices);
    EXPECT_EQ(file.mesh.triangles, sheet.triangles);
  }
}

}  // namespace
}  // namespace scan_to_path::mesh
