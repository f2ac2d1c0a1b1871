// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/read_mesh.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "scan_to_path/common/output_directory.h"
#include "support/expect_input_error.h"
#include "support/mesh_text.h"
#include "support/meshes.h"

namespace scan_to_path::mesh {
namespace {

using test::expectInputError;

struct Sample {
  MeshFormat format;
  std::string content;
};

/// The cube in all formats. Its coordinates are exact in float.
std::vector<Sample> cubes() {
  const TriangleMesh cube = test::cubeMesh(0.5);
  return {{MeshFormat::ply, formatPly(cube, PlyFormat::ascii)},
          {MeshFormat::ply, formatPly(cube, PlyFormat::binary_little_endian)},
          {MeshFormat::ply, formatPly(cube, PlyFormat::binary_big_endian)},
          {MeshFormat::stl_ascii, test::stlText(cube)},
          {MeshFormat::stl_binary, test::stlBytes(cube)},
          {MeshFormat::obj, test::objText(cube)},
          {MeshFormat::off, test::offText(cube)}};
}

/// Corner places triangle by triangle: what must agree whatever the numbering of the vertices is.
std::vector<Eigen::Vector3d> corners(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> result;
  for (const auto& triangle : mesh.triangles) {
    for (const auto index : triangle) result.push_back(mesh.vertices[index]);
  }
  return result;
}

TEST(ReadMesh, AllFormatsGiveTheSameCube) {
  const TriangleMesh cube = test::cubeMesh(0.5);
  for (const auto& sample : cubes()) {
    EXPECT_EQ(probeMesh(sample.content), sample.format) << meshFormatName(sample.format);
    const MeshFile file = parseMesh(sample.content, "cube");
    EXPECT_EQ(file.format, sample.format);
    EXPECT_EQ(file.faces, 12U);
    EXPECT_EQ(file.dropped_degenerate, 0U);
    EXPECT_EQ(file.mesh.vertices.size(), 8U) << meshFormatName(sample.format);
    EXPECT_EQ(corners(file.mesh), corners(cube)) << meshFormatName(sample.format);
  }
}

TEST(ReadMesh, CarriageReturnsMakeNoDifference) {
  for (const auto& sample : cubes()) {
    if (sample.content.find('\0') != std::string::npos) continue;
    std::string dos;
    for (const char c : sample.content) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(corners(parseMesh(dos, "cube").mesh), corners(test::cubeMesh(0.5))) << meshFormatName(sample.format);
  }
}

// Cutting a file anywhere must not end in a crash, and a mesh that comes out must be valid.
TEST(ReadMesh, TruncatedFilesAreRefusedOrValid) {
  for (const auto& sample : cubes()) {
    std::size_t accepted = 0;
    for (std::size_t length = 0; length < sample.content.size(); ++length) {
      try {
        const MeshFile file = parseMesh(sample.content.substr(0, length), "cut");
        ++accepted;
        // OBJ has no end mark; the others are whole but for white space or a number's last digits.
        const bool is_whole = file.mesh.triangles.size() == 12;
        EXPECT_TRUE(is_whole || sample.format == MeshFormat::obj) << meshFormatName(sample.format) << " at " << length;
      } catch (const InputError&) {
      }
    }
    // After the last thing that counts come a line end and, in an STL file, the solid's name: " test part".
    if (sample.format != MeshFormat::obj) {
      EXPECT_LE(accepted, 11U) << meshFormatName(sample.format);
    }
  }
}

TEST(ReadMesh, FilesAreToldByContentNotByName) {
  const std::string path = ::testing::TempDir() + "cube.txt";
  writeFileAtomically(path, test::stlBytes(test::cubeMesh(1)));
  EXPECT_EQ(readMesh(path).format, MeshFormat::stl_binary);
  std::filesystem::remove(path);
  expectInputError([&] { readMesh(path); }, "cannot read " + path);
}

TEST(ReadMesh, OtherFilesAreNoMeshes) {
  EXPECT_EQ(probeMesh(""), MeshFormat::none);
  EXPECT_EQ(probeMesh("# scan_to_path samples 1\nt,j1,voltage\n0,1,2\n"), MeshFormat::none);
  EXPECT_EQ(probeMesh("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\n"), MeshFormat::none);
  EXPECT_EQ(probeMesh("ply\nformat ascii 1.0\nelement vertex 0\nend_header\n"), MeshFormat::none);
  EXPECT_EQ(probeMesh(std::string(500, '\0') + "x"), MeshFormat::none);
  EXPECT_EQ(probeMesh("ISO-10303-21;\nHEADER;\n"), MeshFormat::none);
  expectInputError([] { parseMesh("", "f"); }, "f: file is empty");
  expectInputError([] { parseMesh("hello", "f"); }, "f: content is not a PLY, STL, OBJ or OFF mesh");
  expectInputError([] { parseMesh("ply\nformat ascii 1.0\nelement vertex 0\nend_header\n", "f"); }, "a cloud");
}

TEST(ReadMesh, DegenerateTrianglesAreDroppedAndCounted) {
  const MeshFile file = parseMesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.5 0 0\nf 1 2 3\nf 1 4 2\nf 1 1 2\n", "f.obj");
  EXPECT_EQ(file.faces, 3U);
  EXPECT_EQ(file.dropped_degenerate, 2U);
  EXPECT_EQ(file.mesh.triangles.size(), 1U);
  expectInputError([] { parseMesh("v 0 0 0\nv 1 0 0\nf 1 2 2\n", "f.obj"); },
                   "f.obj: number of triangles is 0 (1 without an area were dropped), must be at least 1");
}

TEST(ReadMesh, CoordinatesMustBeFinite) {
  const std::string faces = "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expectInputError([&] { parseMesh("v 0 0 nan" + faces, "f.obj"); }, "f.obj line 1: vertex z is nan, must be finite");
  expectInputError([&] { parseMesh("v 0 -inf 0" + faces, "f.obj"); }, "vertex y is -inf");
  expectInputError([&] { parseMesh("v 1e10 0 0" + faces, "f.obj"); },
                   "vertex x is 1e+10, must be finite and within 1e9");
  expectInputError([] { parseMesh("OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "f.off"); },
                   "f.off line 4: vertex z");
  TriangleMesh cube = test::cubeMesh(1);
  cube.vertices[3].y() = std::nan("");
  expectInputError([&] { parseMesh(formatPly(cube), "f.ply"); }, "vertex y is nan");
  expectInputError([&] { parseMesh(test::stlBytes(cube), "f.stl"); }, "f.stl triangle 0 byte 84: vertex y is nan");
}

/// Files that are not part of the package: given by SCAN_TO_PATH_DATA.
TEST(ReadMesh, RealPartsHaveTheirKnownSizes) {
  const char* const directory = std::getenv("SCAN_TO_PATH_DATA");
  if (directory == nullptr) GTEST_SKIP() << "SCAN_TO_PATH_DATA is not set";
  const std::filesystem::path data = directory;
  const MeshFile wavy = readMesh(data / "wavy_mesh_with_hole.ply");
  EXPECT_EQ(wavy.mesh.vertices.size(), 757U);
  EXPECT_EQ(wavy.faces, 1347U);
  EXPECT_EQ(wavy.mesh.triangles.size() + wavy.dropped_degenerate, 1347U);
  const MeshFile part = readMesh(data / "part_scan.ply");
  EXPECT_EQ(part.faces, 3277U);
  EXPECT_LT((part.mesh.bounds().sizes() - Eigen::Vector3d(0.32, 0.51, 0.04)).norm(), 0.02);
  const MeshFile beetle = readMesh(data / "beetle-alt.obj");
  EXPECT_EQ(beetle.mesh.vertices.size(), 19887U);
  EXPECT_EQ(beetle.faces, 38656U);
}

}  // namespace
}  // namespace scan_to_path::mesh
