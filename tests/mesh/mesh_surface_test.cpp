// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/mesh_surface.h"

#include <gtest/gtest.h>

#include <memory>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/geometry/scene.h"
#include "support/meshes.h"
#include "support/surface_oracle.h"

namespace scan_to_path::mesh {
namespace {

using geometry::Frame;
using geometry::Vector3;

constexpr double cell = 0.002;  // [m]

TriangleMesh sPartMesh() {
  return test::gridMesh(120, 80, [](double u, double v) { return geometry::SPart().at(0.24 * u, 0.16 * v).point; });
}

TEST(MeshSurface, FollowsTheSurfaceThatItWasCutFrom) {
  const geometry::SPart part;
  const MeshSurface surface(sPartMesh());
  Random random(1);
  // Chord height of a cell's diagonal at curvatures up to 17.3 / m: k d^2 / 8 with d^2 = 2 cell^2.
  const double chord = 17.3 * 2 * cell * cell / 8;
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(0.001, 0.239);
    const double y = random.uniform(0.001, 0.159);
    const geometry::Ray ray = {{x, y, 0.08}, -Vector3::UnitZ()};
    const auto hit = surface.castRay(ray);
    const auto truth = part.castRay(ray);
    ASSERT_TRUE(hit);
    // Measured along the ray, the slope of at most 0.63 makes it longer by 1 / cos.
    EXPECT_NEAR(hit->distance, truth->distance, 1.2 * chord);
    EXPECT_LT(geometry::angleBetween(hit->normal, truth->normal), 17.3 * 2 * cell);
    EXPECT_LT((hit->point - ray.origin - hit->distance * ray.direction).norm(), 1e-15);
    const Vector3 p(x, y, 0.01);
    EXPECT_NEAR((surface.closestPoint(p).point - p).norm(), (part.closestPoint(p).point - p).norm(), chord);
  }
}

// Mutation twin: a mesh wound the other way must be seen by its normals.
TEST(MeshSurface, NormalsTurnWithTheWinding) {
  TriangleMesh turned = sPartMesh();
  for (auto& triangle : turned.triangles) std::swap(triangle[1], triangle[2]);
  const geometry::Ray ray = {{0.1, 0.1, 0.08}, -Vector3::UnitZ()};
  EXPECT_GT(MeshSurface(sPartMesh()).castRay(ray)->normal.z(), 0.5);
  EXPECT_LT(MeshSurface(turned).castRay(ray)->normal.z(), -0.5);
}

TEST(MeshSurface, AnswersMoveWithTheMesh) {
  Random random(2);
  const auto surface = std::make_shared<MeshSurface>(test::wavySheet(30));
  const Frame T = test::randomFrame(random);
  TriangleMesh moved_mesh = surface->mesh();
  for (auto& vertex : moved_mesh.vertices) vertex = T * vertex;
  const MeshSurface moved(moved_mesh);
  const geometry::PosedSurface posed(surface, T);
  for (int i = 0; i < 500; ++i) {
    const geometry::Ray local = test::randomRayTowards(random, {0.1, 0.1, 0}, 0.5, 0.08);
    const geometry::Ray ray = {T * local.origin, T.linear() * local.direction};
    const auto a = posed.castRay(ray);
    const auto b = moved.castRay(ray);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a && std::abs(a->normal.dot(ray.direction)) > 1e-2) {
      // Rounding of coordinates of 1 m over the sine of the angle, and of 7 mm edges for the normal.
      EXPECT_NEAR(a->distance, b->distance, 1e-13);
      EXPECT_LT((a->normal - b->normal).norm(), 1e-12);
    }
    const Vector3 p = ray.origin;
    EXPECT_LT((posed.closestPoint(p).point - moved.closestPoint(p).point).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace scan_to_path::mesh
