// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace scan_to_path::mesh {
namespace {

TEST(TriangleMesh, CubeHasItsBoundsAreaAndOutwardNormals) {
  const TriangleMesh cube = test::cubeMesh(2.0);
  EXPECT_EQ(cube.bounds().min(), Eigen::Vector3d::Zero());
  EXPECT_EQ(cube.bounds().max(), Eigen::Vector3d::Constant(2.0));
  EXPECT_DOUBLE_EQ(cube.area(), 24.0);
  for (std::size_t i = 0; i < cube.triangles.size(); ++i) {
    const Eigen::Vector3d outward = cube.vertices[cube.triangles[i][0]] - Eigen::Vector3d::Ones();
    EXPECT_GT(cube.faceNormal(i).dot(outward), 0.9);
  }
}

TEST(TriangleMesh, ScalingIsUniform) {
  const TriangleMesh cube = scaled(test::cubeMesh(1.0), 0.001);
  EXPECT_DOUBLE_EQ(cube.area(), 6e-6);
  EXPECT_EQ(cube.triangles, test::cubeMesh(1.0).triangles);
}

TEST(TriangleMesh, EmptyMeshHasEmptyBoundsAndNoArea) {
  EXPECT_TRUE(TriangleMesh().bounds().isEmpty());
  EXPECT_EQ(TriangleMesh().area(), 0.0);
}

}  // namespace
}  // namespace scan_to_path::mesh
