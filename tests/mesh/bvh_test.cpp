// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/mesh/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "scan_to_path/mesh/read_mesh.h"
#include "support/expect_input_error.h"
#include "support/meshes.h"
#include "support/surface_oracle.h"

namespace scan_to_path::mesh {
namespace {

using Eigen::Vector3d;
using geometry::Ray;

/// Möller and Trumbore's test, another algorithm than the tree's; infinity for a miss.
double rayTriangle(const TriangleMesh& mesh, std::size_t triangle, const Ray& ray) {
  const auto& [ia, ib, ic] = mesh.triangles[triangle];
  const Vector3d a = mesh.vertices[ia];
  const Vector3d ab = mesh.vertices[ib] - a;
  const Vector3d ac = mesh.vertices[ic] - a;
  const Vector3d p = ray.direction.cross(ac);
  const double determinant = ab.dot(p);
  const Vector3d q = (ray.origin - a).cross(ab);
  const double u = (ray.origin - a).dot(p) / determinant;
  const double v = ray.direction.dot(q) / determinant;
  const double t = ac.dot(q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : std::numeric_limits<double>::infinity();
}

double bruteRay(const TriangleMesh& mesh, const Ray& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) nearest = std::min(nearest, rayTriangle(mesh, i, ray));
  return nearest;
}

double segmentDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

/// Distance to a triangle: its plane where p lies over it, its edges otherwise.
double bruteDistance(const TriangleMesh& mesh, const Vector3d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vector3d& a = mesh.vertices[mesh.triangles[i][0]];
    const Vector3d& b = mesh.vertices[mesh.triangles[i][1]];
    const Vector3d& c = mesh.vertices[mesh.triangles[i][2]];
    const Vector3d n = mesh.faceNormal(i);
    const bool is_over =
        n.cross(b - a).dot(p - a) >= 0 && n.cross(c - b).dot(p - b) >= 0 && n.cross(a - c).dot(p - c) >= 0;
    nearest = std::min(
        nearest, is_over ? std::abs(n.dot(p - a))
                         : std::min({segmentDistance(p, a, b), segmentDistance(p, b, c), segmentDistance(p, c, a)}));
  }
  return nearest;
}

/// Triangles of all sizes at random places: boxes overlap, nothing is shared.
TriangleMesh soup(Random& random, int triangles) {
  TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const Vector3d centre = test::randomVector(random, 0.1);
    const double size = std::pow(10.0, random.uniform(-4, -1));
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(centre + test::randomVector(random, size));
    const auto first = static_cast<std::uint32_t>(3 * i);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TriangleMesh sphereMesh(double radius, std::uint32_t cells) {
  return test::gridMesh(cells, cells, [radius](double u, double v) -> Vector3d {
    // The seam and the poles are closed exactly, not to rounding.
    const double longitude = 2 * M_PI * (u == 1.0 ? 0.0 : u);
    const double sine = v == 0.0 || v == 1.0 ? 0.0 : std::sin(M_PI * v);
    return radius * Vector3d(sine * std::cos(longitude), sine * std::sin(longitude), -std::cos(M_PI * v));
  });
}

void expectAgreesWithBruteForce(const TriangleMesh& mesh, Random& random, int cases) {
  const Bvh tree(mesh);
  const Vector3d centre = mesh.bounds().center();
  const double size = mesh.bounds().diagonal().norm();
  for (int i = 0; i < cases; ++i) {
    const Ray ray = test::randomRayTowards(random, centre, random.uniform(0.0, 2.0) * size, 0.4 * size);
    const double expected = bruteRay(mesh, ray);
    const auto hit = tree.castRay(ray);
    // Rays through an edge, where rounding decides which of the oracle's triangles has it, are too rare to be met.
    ASSERT_EQ(hit.has_value(), std::isfinite(expected)) << "case " << i;
    if (hit) {
      // A grazing triangle's plane is met with the inverse of the angle's sine.
      const double sine = std::abs(ray.direction.dot(mesh.faceNormal(hit->triangle)));
      EXPECT_NEAR(hit->distance, expected, 2e-14 * size / std::max(1e-9, sine)) << "case " << i;
    }
    const Vector3d p = centre + test::randomVector(random, size);
    EXPECT_NEAR(std::sqrt(tree.closestPoint(p).squared_distance), bruteDistance(mesh, p), 1e-14 * size) << "case " << i;
  }
}

TEST(Bvh, AgreesWithBruteForceOnRandomTriangles) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    expectAgreesWithBruteForce(soup(random, 300), random, 300);
  }
}

TEST(Bvh, AgreesWithBruteForceOnASheet) {
  Random random(6);
  expectAgreesWithBruteForce(test::wavySheet(20), random, 500);
}

TEST(Bvh, AgreesWithBruteForceOnRealParts) {
  const char* const directory = std::getenv("SCAN_TO_PATH_DATA");
  if (directory == nullptr) GTEST_SKIP() << "SCAN_TO_PATH_DATA is not set";
  for (const char* const name : {"wavy_mesh_with_hole.ply", "part_scan.ply", "beetle-alt.obj"}) {
    Random random(7);
    expectAgreesWithBruteForce(readMesh(std::filesystem::path(directory) / name).mesh, random, 100);
  }
}

TEST(Bvh, RaysCannotLeaveAClosedMesh) {
  const TriangleMesh sphere = sphereMesh(0.1, 24);
  const Bvh tree(sphere);
  Random random(8);
  const auto expectHit = [&](const Vector3d& origin, const Vector3d& target) {
    EXPECT_TRUE(tree.castRay({origin, (target - origin).normalized()})) << "towards " << target.transpose();
  };
  for (const auto& triangle : sphere.triangles) {
    const Vector3d origin = test::randomVector(random, 0.04);
    const Vector3d& a = sphere.vertices[triangle[0]];
    const Vector3d& b = sphere.vertices[triangle[1]];
    expectHit(origin, a);
    expectHit(Vector3d::Zero(), a);
    expectHit(origin, 0.5 * (a + b));
    const double share = random.uniform();
    expectHit(origin, share * a + (1 - share) * b);
  }
}

TEST(Bvh, AxisParallelRaysHitEveryVertexOfAnAlignedGrid) {
  const TriangleMesh grid = test::gridMesh(16, 16, [](double u, double v) { return Vector3d(u, v, 0.25); });
  const Bvh tree(grid);
  for (const auto& vertex : grid.vertices) {
    const auto hit = tree.castRay({vertex + Vector3d::UnitZ(), -Vector3d::UnitZ()});
    ASSERT_TRUE(hit) << vertex.transpose();
    EXPECT_EQ(hit->distance, 1.0);
  }
}

TEST(Bvh, HitsFromBothSidesWithinTheMaximumDistance) {
  const TriangleMesh cube = test::cubeMesh(1.0);
  const Bvh tree(cube);
  const Ray from_outside = {{0.3, 0.4, 3.0}, -Vector3d::UnitZ()};
  EXPECT_EQ(tree.castRay(from_outside)->distance, 2.0);
  EXPECT_EQ(tree.castRay(from_outside, 2.0)->distance, 2.0);
  EXPECT_FALSE(tree.castRay(from_outside, std::nextafter(2.0, 0.0)));
  EXPECT_EQ(tree.castRay({{0.3, 0.4, 0.5}, Vector3d::UnitZ()})->distance, 0.5);
  EXPECT_FALSE(tree.castRay({{0.3, 0.4, 3.0}, Vector3d::UnitZ()}));
  // A ray that starts on a face sees the opposite one.
  EXPECT_EQ(tree.castRay({{0.3, 0.4, 1.0}, -Vector3d::UnitZ()})->distance, 1.0);
}

TEST(Bvh, EqualDistancesGiveTheLowerIndex) {
  TriangleMesh twice = test::cubeMesh(1.0);
  const auto once = twice.triangles;
  twice.triangles.insert(twice.triangles.end(), once.begin(), once.end());
  const Bvh tree(twice);
  Random random(9);
  for (int i = 0; i < 100; ++i) {
    const Ray ray = test::randomRayTowards(random, {0.5, 0.5, 0.5}, 3.0, 0.4);
    EXPECT_LT(tree.castRay(ray)->triangle, once.size());
  }
}

TEST(Bvh, ClosestPointTellsTheSideAtEdgesAndCorners) {
  const TriangleMesh cube = test::cubeMesh(1.0);
  const Bvh tree(cube);
  Random random(10);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p = Vector3d::Constant(0.5) + test::randomVector(random, 1.5);
    const Bvh::Closest closest = tree.closestPoint(p);
    const bool is_inside = (p.array() > 0.0).all() && (p.array() < 1.0).all();
    EXPECT_EQ((p - closest.point).dot(cube.faceNormal(closest.triangle)) < 0.0, is_inside) << p.transpose();
  }
}

TEST(Bvh, ClustersAndCopiesMakeNoDeepTree) {
  TriangleMesh cluster;
  // Every level of halving holds one triangle: splits in the middle of the box would go 200 deep.
  for (int i = 0; i < 200; ++i) {
    const double place = std::pow(0.75, i);
    const auto first = static_cast<std::uint32_t>(cluster.vertices.size());
    for (const auto& offset : {Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), Vector3d(0, 0.1, 0)}) {
      cluster.vertices.push_back(place * (Vector3d(1, 1, 1) + offset));
    }
    cluster.triangles.push_back({first, first + 1, first + 2});
  }
  // And many equal ones, which no split can part.
  for (int i = 0; i < 1000; ++i) cluster.triangles.push_back({0, 1, 2});
  const Bvh tree(cluster);
  EXPECT_EQ(tree.castRay({{1.02, 1.02, 2}, -Vector3d::UnitZ()})->triangle, 0U);
  EXPECT_LT(std::sqrt(tree.closestPoint({1, 1, 1}).squared_distance), 1e-15);
}

TEST(Bvh, SmallestMeshHasNoNodes) {
  TriangleMesh one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  const Bvh tree(one);
  EXPECT_EQ(tree.nodeCount(), 0U);
  EXPECT_TRUE(tree.castRay({{0.2, 0.2, 1}, -Vector3d::UnitZ()}));
  EXPECT_FALSE(tree.castRay({{0.8, 0.8, 1}, -Vector3d::UnitZ()}));
  EXPECT_FALSE(tree.castRay({{-1, 0.2, 0}, Vector3d::UnitX()}));  // in its plane
}

TEST(Bvh, RefusesAnEmptyMesh) {
  test::expectInputError([] { Bvh{TriangleMesh{}}; }, "mesh: number of triangles is 0, must be at least 1");
}

}  // namespace
}  // namespace scan_to_path::mesh
