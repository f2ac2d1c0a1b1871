// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "bvh_builder.h"

#include <algorithm>
#include <cmath>

namespace scan_to_path::mesh {
namespace {

constexpr int bins = 16;
constexpr std::size_t largest_leaf = 4;
constexpr int depth_of_median_splits = 45;  // below it every split halves: 2^32 triangles end above deepest_bvh

struct Box {
  std::array<float, 3> low = {INFINITY, INFINITY, INFINITY};
  std::array<float, 3> high = {-INFINITY, -INFINITY, -INFINITY};

  void extend(const Box& other) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }

  /// Half the surface area; 0 when empty.
  float halfArea() const {
    const float x = high[0] - low[0];
    const float y = high[1] - low[1];
    const float z = high[2] - low[2];
    return x < 0.0F ? 0.0F : x * y + y * z + z * x;
  }
};

struct Primitive {
  Box box;
  std::uint32_t index = 0;

  /// Twice the centre: a factor changes no split.
  float centre(int axis) const { return box.low[axis] + box.high[axis]; }
};

/// Where a range is cut: primitives of bins below `bin` go left.
struct Split {
  int axis = -1;
  int bin = 0;
  float cost = INFINITY;  ///< sum over both sides of half area times primitives
};

/// Maps centres along an axis to bins.
struct Binning {
  float low = 0.0F;
  float scale = 0.0F;

  int binOf(float centre) const { return std::min(bins - 1, static_cast<int>((centre - low) * scale)); }
};

class Builder {
public:
  explicit Builder(const TriangleMesh& mesh) : primitives_(mesh.triangles.size()) {
    double largest = 0.0;
    for (const auto& vertex : mesh.vertices) largest = std::max(largest, vertex.lpNorm<Eigen::Infinity>());
    // More than the rounding to float and than that of the ray's arithmetic, so that no box is too small.
    const double pad = std::ldexp(largest, -22) + 1e-30;
    for (std::uint32_t i = 0; i < primitives_.size(); ++i) {
      primitives_[i].index = i;
      for (int k = 0; k < 3; ++k) {
        const auto& [a, b, c] = mesh.triangles[i];
        const auto [low, high] = std::minmax({mesh.vertices[a][k], mesh.vertices[b][k], mesh.vertices[c][k]});
        primitives_[i].box.low[k] = static_cast<float>(low - pad);
        primitives_[i].box.high[k] = static_cast<float>(high + pad);
      }
    }
    nodes_.reserve(primitives_.size());
  }

  BvhLayout build() {
    BvhLayout layout;
    layout.root = subtree(0, primitives_.size(), 0);
    layout.nodes = std::move(nodes_);
    for (const auto& primitive : primitives_) layout.order.push_back(primitive.index);
    return layout;
  }

private:
  Bvh::Child subtree(std::size_t begin, std::size_t end, int depth) {
    Box box;
    for (std::size_t i = begin; i < end; ++i) box.extend(primitives_[i].box);
    Bvh::Child child = {box.low, box.high, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
    if (end - begin <= largest_leaf) return child;
    const std::size_t middle = partition(begin, end, depth);
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    const Bvh::Child left = subtree(begin, middle, depth + 1);
    const Bvh::Child right = subtree(middle, end, depth + 1);
    nodes_[node] = {left, right};
    child.first = node;
    child.count = 0;
    return child;
  }

  /// Orders [begin, end) into two sides; returns where the second begins, never begin or end.
  std::size_t partition(std::size_t begin, std::size_t end, int depth) {
    std::array<Binning, 3> binning;
    const Split split = depth < depth_of_median_splits ? cheapestSplit(begin, end, binning) : Split{};
    if (split.axis < 0) return begin + (end - begin) / 2;
    const Binning& axis_binning = binning[split.axis];
    const auto first = primitives_.begin();
    const auto cut = std::partition(first + begin, first + end, [&](const Primitive& primitive) {
      return axis_binning.binOf(primitive.centre(split.axis)) < split.bin;
    });
    return static_cast<std::size_t>(cut - first);
  }

  /// The cheapest of all cuts between bins; axis -1 when all centres are at one place.
  Split cheapestSplit(std::size_t begin, std::size_t end, std::array<Binning, 3>& binning) const {
    Box centres;
    for (std::size_t i = begin; i < end; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        centres.low[axis] = std::min(centres.low[axis], primitives_[i].centre(axis));
        centres.high[axis] = std::max(centres.high[axis], primitives_[i].centre(axis));
      }
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = centres.high[axis] - centres.low[axis];
      // Too narrow to bin: the scale would overflow.
      if (!(extent > 1e-30F)) continue;
      binning[axis] = {centres.low[axis], static_cast<float>(bins) * 0.99999F / extent};
      const Split split = cheapestSplitAlong(axis, begin, end, binning[axis]);
      if (split.cost < best.cost) best = split;
    }
    return best;
  }

  Split cheapestSplitAlong(int axis, std::size_t begin, std::size_t end, const Binning& binning) const {
    std::array<Box, bins> boxes;
    std::array<std::uint32_t, bins> counts = {};
    for (std::size_t i = begin; i < end; ++i) {
      const int bin = binning.binOf(primitives_[i].centre(axis));
      boxes[bin].extend(primitives_[i].box);
      ++counts[bin];
    }
    std::array<float, bins> right_cost = {};  // of bins from k on
    Box box;
    std::uint32_t count = 0;
    for (int k = bins - 1; k > 0; --k) {
      box.extend(boxes[k]);
      count += counts[k];
      right_cost[k] = box.halfArea() * static_cast<float>(count);
    }
    Split best;
    box = {};
    count = 0;
    for (int k = 1; k < bins; ++k) {
      box.extend(boxes[k - 1]);
      count += counts[k - 1];
      const float cost = box.halfArea() * static_cast<float>(count) + right_cost[k];
      if (count > 0 && count < end - begin && cost < best.cost) best = {axis, k, cost};
    }
    return best;
  }

  std::vector<Primitive> primitives_;
  std::vector<Bvh::Node> nodes_;
};

}  // namespace

BvhLayout buildBvh(const TriangleMesh& mesh) { return Builder(mesh).build(); }

}  // namespace scan_to_path::mesh
