// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/mesh/mesh_builder.h"

#include <gmock/gmock.h>

#include <limits>

#include "support/expect_input_error.h"

namespace scan_to_path::mesh {
namespace {

using test::expectInputError;
using testing::ElementsAre;
using Triangle = std::array<std::uint32_t, 3>;

std::string here() { return "file line 7"; }

/// The corners of a regular polygon, and one more vertex at the first one's place.
MeshBuilder polygon(int corners) {
  MeshBuilder builder;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2.0 * M_PI * (i % corners) / corners;
    builder.addVertex({std::cos(angle), std::sin(angle), 0.5}, here);
  }
  return builder;
}

TEST(MeshBuilder, PolygonsBecomeFansFromTheirFirstVertex) {
  MeshBuilder builder = polygon(5);
  builder.addPolygon({2, 3, 4, 0, 1}, here);
  builder.addPolygon({0, 1, 2}, here);
  const MeshFile file = builder.finish(MeshFormat::obj, "pentagon");
  EXPECT_THAT(file.mesh.triangles,
              ElementsAre(Triangle{2, 3, 4}, Triangle{2, 4, 0}, Triangle{2, 0, 1}, Triangle{0, 1, 2}));
  EXPECT_EQ(file.faces, 2U);
  EXPECT_EQ(file.dropped_degenerate, 0U);
  EXPECT_EQ(file.format, MeshFormat::obj);
}

TEST(MeshBuilder, TrianglesWithoutAnAreaAreDroppedAndCounted) {
  MeshBuilder builder = polygon(4);
  builder.addPolygon({0, 1, 2}, here);
  builder.addPolygon({0, 1, 1}, here);
  builder.addPolygon({0, 4, 2}, here);  // two of its corners are one place
  const MeshFile file = builder.finish(MeshFormat::off, "square");
  EXPECT_EQ(file.mesh.triangles.size(), 1U);
  EXPECT_EQ(file.dropped_degenerate, 2U);
  MeshBuilder flat = polygon(4);
  flat.addPolygon({0, 4, 2}, here);
  expectInputError([&flat] { flat.finish(MeshFormat::off, "flat"); }, "flat: number of triangles is 0");
}

TEST(MeshBuilder, RefusesVerticesThatAreNoPlace) {
  MeshBuilder builder;
  const auto add = [&builder](double y) { return [&builder, y] { builder.addVertex({0.0, y, 0.0}, here); }; };
  expectInputError(add(std::numeric_limits<double>::infinity()), "file line 7: vertex y is inf");
  expectInputError(add(1.1e9), "file line 7: vertex y is 1.1e+09");
  add(1e9)();
  EXPECT_THROW(add(std::numeric_limits<double>::quiet_NaN())(), InputError);
  EXPECT_EQ(builder.vertexCount(), 1U);
}

TEST(MeshBuilder, RefusesFacesOfVerticesThatAreNotThere) {
  MeshBuilder builder = polygon(3);
  expectInputError([&builder] { builder.addPolygon({0, 1, 4}, here); }, "vertex index (counted from 0) is 4");
  expectInputError([&builder] { builder.addPolygon({0, -1, 2}, here); }, "vertex index (counted from 0) is -1");
  expectInputError([&builder] { builder.addPolygon({0, 1}, here); }, "number of a face's vertices is 2");
}

}  // namespace
}  // namespace scan_to_path::mesh
