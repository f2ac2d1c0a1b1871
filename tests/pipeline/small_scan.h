// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/pipeline/cell.h"
#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/sensing/emulate_scan.h"

namespace scan_to_path::pipeline {

/// Where the tests find the shipped arm.
inline const std::vector<std::filesystem::path> source_package = {SCAN_TO_PATH_SOURCE_DIR};

/// A saddle of 60 mm by 60 mm: small enough to scan within a second, curved enough to need a fit.
inline geometry::Saddle smallPart() { return geometry::Saddle(0.15, 0.03); }

/// Scan with little noise of the small part, or of a scene, over 60 mm by 60 mm at 4 mm pitch, without a table.
inline scan::SampleLog smallScan(const geometry::Surface& scene = smallPart(),
                                 sensing::RasterOrder order = sensing::RasterOptions().order) {
  const Cell cell = makeCell(CellOptions(), source_package);
  sensing::EmulationOptions options;
  options.raster.order = order;
  options.errors.noise_sigma = 2e-6;
  const Eigen::AlignedBox2d rectangle(Eigen::Vector2d(-0.03, -0.03), Eigen::Vector2d(0.03, 0.03));
  return sensing::emulateScan(scene, rectangle, cell.T_base_workpiece, cell.robot, cell.encoders, cell.laser,
                              cell.T_tip_sensor, options)
      .log;
}

/// A groove across the small part whose bottom, of a radius of 12 mm, larger balls do not reach.
class Groove : public geometry::HeightField {
public:
  Groove() : HeightField({-0.03, 0.03, -0.03, 0.03}, {-depth, 0.0, 2.0 * depth / (width * width)}) {}
  geometry::HeightJet jet(double x, double) const override {
    const double e = -depth * std::exp(-x * x / (width * width));
    geometry::HeightJet jet;
    jet.z = e;
    jet.zx = -2.0 * x / (width * width) * e;
    jet.zxx = (4.0 * x * x / std::pow(width, 4) - 2.0 / (width * width)) * e;
    return jet;
  }

private:
  static constexpr double depth = 0.003;
  static constexpr double width = 0.0085;
};

/// A ball that does not reach the groove's bottom. Rows and moves are coarse: a partial path is planned many times
/// over.
inline JobOptions grooveOptions() {
  JobOptions options;
  options.path.ball_radius = 0.0135;
  options.path.scallop_height = 3e-4;
  options.path.chord_tolerance = 5e-5;
  options.motion.chord_tolerance = 1e-4;
  return options;
}

/// A directory of this test's own, empty.
inline std::filesystem::path freshDirectory(const std::string& name) {
  const std::filesystem::path directory =
      std::filesystem::path(::testing::TempDir()) / ("scan_to_path_" + std::to_string(::getpid()) + "_" + name);
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  return directory;
}

}  // namespace scan_to_path::pipeline
