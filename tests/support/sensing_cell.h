// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/geometry/worlds.h"
#include "scan_to_path/sensing/clock_offset.h"
#include "scan_to_path/sensing/emulate_scan.h"
#include "scan_to_path/sensing/place_samples.h"
#include "support/irb2400.h"

namespace scan_to_path::test {

/// A part on its table, 24 mm below z = 0, in workpiece coordinates.
inline std::shared_ptr<const geometry::Surface> onTable(std::shared_ptr<const geometry::Surface> part) {
  const geometry::Frame T_workpiece_table = geometry::makeFrame({0, 0, -0.024}, geometry::Vector3::Zero());
  auto table = std::make_shared<geometry::PosedSurface>(std::make_shared<geometry::Plane>(), T_workpiece_table);
  return std::make_shared<geometry::Scene>(std::vector<std::shared_ptr<const geometry::Surface>>{part, table});
}

/// The arm with the laser on its flange, over a part.
struct SensingCell {
  robot::Robot robot = irb2400WithLinkage();
  robot::EncoderOptions encoder_options;
  sensing::PointLaserOptions laser;
  geometry::Frame T_tip_sensor = geometry::makeFrame({0.08, 0.0, 0.12}, geometry::Vector3::Zero());
  geometry::Frame T_base_workpiece = geometry::makeFrame({0.85, -0.08, 0.45}, geometry::Vector3::Zero());
  std::shared_ptr<const geometry::Surface> scene = onTable(std::make_shared<geometry::SPart>());
  Eigen::AlignedBox2d rectangle{Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.24, 0.16)};

  robot::Encoders encoders() const { return {encoder_options, robot}; }

  sensing::EmulatedScan emulate(const sensing::EmulationOptions& options, int threads = 1,
                                const Progress& progress = {}) const {
    return sensing::emulateScan(*scene, rectangle, T_base_workpiece, robot, encoders(), laser, T_tip_sensor, options,
                                threads, progress);
  }

  sensing::PlacedScan place(const scan::SampleLog& log, const sensing::PlacementOptions& options = {},
                            int threads = 1) const {
    return sensing::placeSamples(log, robot, encoders(), laser, T_tip_sensor, options, threads);
  }

  sensing::ClockOffsetEstimate clockOffset(const scan::SampleLog& log,
                                           const sensing::PlacementOptions& placement = {}) const {
    return sensing::estimateClockOffset(log, robot, encoders(), laser, T_tip_sensor, placement);
  }

  /// The same cell with a part of five rows, 26,000 samples at the default rates.
  static SensingCell small() {
    SensingCell cell;
    cell.rectangle.max().y() = 0.02;
    return cell;
  }
};

}  // namespace scan_to_path::test
