// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/mesh/bvh.h"

namespace scan_to_path::mesh {

/// A tree is never deeper than this, so that a traversal's stack has a fixed size.
constexpr int deepest_bvh = 80;

/// Nodes of the tree and the order of the triangles in its leaves.
struct BvhLayout {
  Bvh::Child root;
  std::vector<Bvh::Node> nodes;
  std::vector<std::uint32_t> order;
};

BvhLayout buildBvh(const TriangleMesh& mesh);

}  // namespace scan_to_path::mesh
