// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/mesh/bvh_builder.h"

#include <gmock/gmock.h>

#include <set>

#include "scan_to_path/common/random.h"
#include "support/meshes.h"

namespace scan_to_path::mesh {
namespace {

bool contains(const Bvh::Child& outer, const Bvh::Child& inner) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (inner.low[i] < outer.low[i] || inner.high[i] > outer.high[i]) return false;
  }
  return true;
}

double halfArea(const Bvh::Child& child) {
  const double x = child.high[0] - child.low[0], y = child.high[1] - child.low[1], z = child.high[2] - child.low[2];
  return x * y + y * z + z * x;
}

/// What a walk over the whole tree finds.
struct Walk {
  const TriangleMesh& mesh;
  const BvhLayout& layout;
  std::set<std::uint32_t> seen;
  std::size_t nodes = 0;
  int depth = 0;
  std::uint32_t largest_leaf = 0;
  bool boxes_hold = true;
  double cost = 0.0;  ///< half areas times triangles of the leaves

  Walk(const TriangleMesh& m, const BvhLayout& l) : mesh(m), layout(l) { visit(layout.root, 1); }

  void visit(const Bvh::Child& child, int level) {
    depth = std::max(depth, level);
    if (child.count > 0) return visitLeaf(child);
    ++nodes;
    for (const Bvh::Child& below : layout.nodes.at(child.first)) {
      boxes_hold = boxes_hold && contains(child, below);
      visit(below, level + 1);
    }
  }

  void visitLeaf(const Bvh::Child& leaf) {
    largest_leaf = std::max(largest_leaf, leaf.count);
    cost += halfArea(leaf) * leaf.count;
    for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
      const std::uint32_t triangle = layout.order.at(k);
      EXPECT_TRUE(seen.insert(triangle).second) << "twice: triangle " << triangle;
      for (const std::uint32_t corner : mesh.triangles[triangle]) {
        for (int i = 0; i < 3; ++i) {
          const double value = mesh.vertices[corner][i];
          const auto axis = static_cast<std::size_t>(i);
          boxes_hold = boxes_hold && value >= leaf.low[axis] && value <= leaf.high[axis];
        }
      }
    }
  }
};

void expectSound(const TriangleMesh& mesh, std::uint32_t largest_leaf = 4) {
  const BvhLayout layout = buildBvh(mesh);
  const Walk walk(mesh, layout);
  EXPECT_EQ(walk.seen.size(), mesh.triangles.size());
  EXPECT_EQ(layout.order.size(), mesh.triangles.size());
  EXPECT_EQ(walk.nodes, layout.nodes.size());
  EXPECT_TRUE(walk.boxes_hold);
  EXPECT_LE(walk.depth, deepest_bvh);
  EXPECT_LE(walk.largest_leaf, largest_leaf);
}

TriangleMesh triangles(std::size_t count, const std::function<Eigen::Vector3d(std::size_t)>& place, double size) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const Eigen::Vector3d p = place(i);
    mesh.vertices.insert(mesh.vertices.end(), {p, p + Eigen::Vector3d(size, 0, 0), p + Eigen::Vector3d(0, size, 0)});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(BvhBuilder, EveryTriangleIsInOneLeafAndEveryBoxHoldsWhatIsBelow) {
  for (const std::uint32_t cells : {1U, 2U, 7U, 60U}) expectSound(test::wavySheet(cells));
  expectSound(test::cubeMesh(0.1));
  Random random(1);
  expectSound(triangles(
      3000, [&](std::size_t) { return Eigen::Vector3d(random.gaussian(), random.gaussian(), random.gaussian()); },
      0.05));
}

TEST(BvhBuilder, AVertexThatMovesLeavesItsBox) {  // twin: the walk sees a box that does not hold
  TriangleMesh mesh = test::wavySheet(7);
  const BvhLayout layout = buildBvh(mesh);
  mesh.vertices[20].z() += 0.1;
  EXPECT_FALSE(Walk(mesh, layout).boxes_hold);
}

TEST(BvhBuilder, TrianglesAtOnePlaceAreHalved) {
  expectSound(triangles(
      5000, [](std::size_t) { return Eigen::Vector3d(0.3, 0.2, 0.1); }, 0.01));
}

TEST(BvhBuilder, NoOrderOfTrianglesMakesItTooDeep) {
  // Every split by cost takes off a few at one end; from some depth on each one halves.
  expectSound(triangles(
      100000,
      [](std::size_t i) { return Eigen::Vector3d(std::pow(2.0, -static_cast<double>(i % 1000) / 8.0), 0.0, 0.0); },
      1e-12));
  expectSound(triangles(
      2000, [](std::size_t i) { return Eigen::Vector3d(std::pow(0.97, i), 0.0, 0.0); }, 1e-30));
}

TEST(BvhBuilder, LargeCoordinatesStillLieInTheirBoxes) {
  Random random(2);
  expectSound(triangles(
      500,
      [&](std::size_t) { return Eigen::Vector3d(1e6 + random.uniform(), -1e6 + random.uniform(), random.uniform()); },
      0.01));
}

TEST(BvhBuilder, CostsLessThanHalvingAnUnevenMesh) {
  // Half of the triangles in one small corner: splitting by area must not put them together with the others.
  Random random(3);
  const TriangleMesh mesh = triangles(
      4000,
      [&](std::size_t i) {
        const double reach = i % 2 == 0 ? 0.001 : 1.0;
        return Eigen::Vector3d(random.uniform(0.0, reach), random.uniform(0.0, reach),
                               random.uniform(0.0, 0.01 * reach));
      },
      1e-4);
  const BvhLayout layout = buildBvh(mesh);
  BvhLayout shuffled = layout;  // twin: the same tree with the triangles of the leaves in the mesh's order
  for (std::uint32_t i = 0; i < shuffled.order.size(); ++i) shuffled.order[i] = i;
  EXPECT_TRUE(Walk(mesh, layout).boxes_hold);
  EXPECT_FALSE(Walk(mesh, shuffled).boxes_hold);
  // Leaves of four among 2000 scattered ones span about 4/2000 of the area each: four per cent of the root's cost
  // per level would be no better than chance.
  EXPECT_LT(Walk(mesh, layout).cost, 0.01 * halfArea(layout.root) * static_cast<double>(mesh.triangles.size()));
}

}  // namespace
}  // namespace scan_to_path::mesh
