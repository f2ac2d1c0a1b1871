// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "emulated_world.h"

#include <algorithm>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/geometry/worlds.h"
#include "scan_to_path/mesh/mesh_surface.h"
#include "scan_to_path/mesh/read_mesh.h"

namespace scan_to_path::tools {
namespace {

constexpr double s_part_table = -0.024;     // [m], spec of the S part
constexpr double sensor_clearance = 0.005;  // [m] over everything

}  // namespace

Workpiece readWorkpiece(const std::filesystem::path& file, std::optional<pipeline::Units> units,
                        std::optional<double> scale, const std::string& units_flag) {
  auto mesh = mesh::readMesh(file).mesh;
  const pipeline::Units unit = units.value_or(pipeline::Units::m);
  const double factor = pipeline::metresPerUnit(unit) * scale.value_or(1.0);
  for (auto& vertex : mesh.vertices) vertex *= factor;
  const Eigen::AlignedBox3d bounds = mesh.bounds();
  if (!units && !scale) pipeline::checkPlausibleSize(bounds, unit, file.filename().string(), units_flag);
  return {std::make_shared<mesh::MeshSurface>(std::move(mesh)), bounds};
}

Workpiece sPart() {
  const auto part = std::make_shared<geometry::SPart>();
  return {part, Eigen::AlignedBox3d(Eigen::Vector3d(0.0, 0.0, -0.02), Eigen::Vector3d(0.24, 0.16, 0.021))};
}

World makeWorld(const WorldOptions& options) {
  const bool own_part = options.workpiece.empty();
  const Workpiece part = own_part ? sPart() : readWorkpiece(options.workpiece, options.units, options.scale);
  std::optional<double> table = options.table;
  if (own_part && !table) table = s_part_table;
  if (!table || options.no_table) return {part.surface, part.bounds, part.bounds.max().z()};
  const auto plane = std::make_shared<geometry::PosedSurface>(
      std::make_shared<geometry::Plane>(), geometry::makeFrame({0.0, 0.0, *table}, geometry::Vector3::Zero()));
  using Surfaces = std::vector<std::shared_ptr<const geometry::Surface>>;
  return {std::make_shared<geometry::Scene>(Surfaces{part.surface, plane}), part.bounds,
          std::max(part.bounds.max().z(), *table)};
}

double rasterHeight(const World& world, const sensing::PointLaserOptions& laser) {
  const auto& bounds = world.bounds;
  return 0.5 * (bounds.min().z() + bounds.max().z()) + 0.5 * (laser.distance_min + laser.distance_max);
}

void checkRasterHeight(const World& world, double height) {
  constexpr double rounding = 1e-9;  // [m]: the height that the message asks for is enough
  const double least = world.top + sensor_clearance;
  if (height >= least - rounding) return;
  throw InputError("emulate.raster.height is " + fixed(height, 6) + " m, must be at least " + fixed(least, 6) +
                   " m: the sensor would run into what it scans, which is " + fixed(world.top, 6) + " m high");
}

}  // namespace scan_to_path::tools
