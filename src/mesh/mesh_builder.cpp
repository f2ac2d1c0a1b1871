// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "scan_to_path/common/error.h"

namespace scan_to_path::mesh {
namespace {

// Beyond this a product of three coordinates loses the part, whatever the file's unit is.
constexpr double largest_coordinate = 1e9;
constexpr std::size_t most_vertices = 0xffffffffU;  // indices are 32-bit

/// True when rounding decides where the triangle faces: its height is below 1e-14 of its longest edge.
bool isDegenerate(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
  const Eigen::Vector3d& b = mesh.vertices[triangle[1]];
  const Eigen::Vector3d& c = mesh.vertices[triangle[2]];
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !((b - a).cross(c - a).norm() > 1e-14 * longest);
}

}  // namespace

bool MeshBuilder::isPlausible(const Eigen::Vector3d& vertex) const {
  return vertex.allFinite() && vertex.lpNorm<Eigen::Infinity>() <= largest_coordinate && vertexCount() < most_vertices;
}

bool MeshBuilder::isPolygon(const std::vector<std::int64_t>& indices) const {
  const auto count = static_cast<std::int64_t>(vertexCount());
  return indices.size() >= 3 &&
         std::all_of(indices.begin(), indices.end(), [count](auto index) { return index >= 0 && index < count; });
}

void MeshBuilder::refuseVertex(const Eigen::Vector3d& vertex, const std::string& where) const {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(vertex[i]) <= largest_coordinate) continue;
    std::ostringstream value;
    value << vertex[i];
    throw InputError(where, std::string("vertex ") + "xyz"[i], value.str(), "finite and within 1e9");
  }
  throw InputError(where, "number of vertices", "over " + std::to_string(most_vertices), "at most that");
}

void MeshBuilder::refusePolygon(const std::vector<std::int64_t>& indices, const std::string& where) const {
  for (const std::int64_t index : indices) {
    if (index >= 0 && static_cast<std::uint64_t>(index) < vertexCount()) continue;
    throw InputError(where, "vertex index (counted from 0)", std::to_string(index),
                     "below " + std::to_string(vertexCount()) + ", the number of vertices so far, and not negative");
  }
  throw InputError(where, "number of a face's vertices", std::to_string(indices.size()), "at least 3");
}

void MeshBuilder::appendFan(const std::vector<std::int64_t>& indices) {
  ++result_.faces;
  const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(indices[i]); };
  for (std::size_t i = 2; i < indices.size(); ++i) result_.mesh.triangles.push_back({at(0), at(i - 1), at(i)});
}

MeshFile MeshBuilder::finish(MeshFormat format, const std::string& name) {
  auto& triangles = result_.mesh.triangles;
  const std::size_t before = triangles.size();
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [this](const auto& triangle) { return isDegenerate(result_.mesh, triangle); }),
                  triangles.end());
  result_.dropped_degenerate = before - triangles.size();
  result_.format = format;
  if (triangles.empty()) {
    throw InputError(name, "number of triangles", "0 (" + std::to_string(before) + " without an area were dropped)",
                     "at least 1");
  }
  return std::move(result_);
}

}  // namespace scan_to_path::mesh
