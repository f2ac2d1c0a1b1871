// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/pipeline/input.h"
#include "scan_to_path/sensing/point_laser.h"

/// What there is to scan when nothing real is: the only code outside geometry and the tests that sees its worlds.
namespace scan_to_path::tools {

/// A part as a surface in metres, in its own frame.
struct Workpiece {
  std::shared_ptr<const geometry::Surface> surface;
  Eigen::AlignedBox3d bounds;
};

/// A mesh file. Throws InputError, also for an implausible size when neither unit nor scale was given; `units_flag` is
/// what would say the unit.
Workpiece readWorkpiece(const std::filesystem::path& file, std::optional<pipeline::Units> units,
                        std::optional<double> scale, const std::string& units_flag = "--units");

/// The S part of the seed, which is scanned and compared with when no file is given.
Workpiece sPart();

struct WorldOptions {
  std::string workpiece;                 ///< mesh file; empty: the S part
  std::optional<pipeline::Units> units;  ///< of the mesh
  std::optional<double> scale;           ///< factor on the mesh's coordinates
  std::optional<double> table;           ///< height of a table plane [m]; the S part has one by default
  bool no_table = false;
};

/// A part with what is behind it, in the workpiece frame.
struct World {
  std::shared_ptr<const geometry::Surface> scene;
  Eigen::AlignedBox3d bounds;  ///< of the part
  double top = 0.0;            ///< highest point of part and table [m]

  /// What is scanned, in the x-y plane [m].
  Eigen::AlignedBox2d rectangle() const { return {bounds.min().head<2>(), bounds.max().head<2>()}; }
};

/// Throws InputError as readWorkpiece does.
World makeWorld(const WorldOptions& options);

/// Of the raster over z = 0 [m]: the sensor is carried so that the part's heights lie in the middle of its range.
double rasterHeight(const World& world, const sensing::PointLaserOptions& laser);

/// Throws InputError for a raster that carries the sensor into the part or the table, or closer than 5 mm over their
/// highest point: no sensor could be carried there. `height` as emulate.raster.height [m].
void checkRasterHeight(const World& world, double height);

}  // namespace scan_to_path::tools
