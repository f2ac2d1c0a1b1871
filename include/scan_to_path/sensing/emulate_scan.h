// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "scan_to_path/common/options.h"
#include "scan_to_path/common/progress.h"
#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/robot/encoders.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/scan/sample_log.h"
#include "scan_to_path/sensing/point_laser.h"
#include "scan_to_path/sensing/raster_plan.h"
#include "scan_to_path/sensing/sensor_errors.h"

namespace scan_to_path::sensing {

/// An emulated scan: the raster, how often things are read, and what goes wrong. An error set of the package is
/// `options.errors = errorPreset(set)`.
struct EmulationOptions {
  RasterOptions raster;
  ErrorOptions errors;
  double sample_rate = 1000.0;
  double joint_rate = 1000.0;
  int seed = 1;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.raster, Field{"raster"});
    visit(self.errors, Field{"errors"});
    visit(self.sample_rate, Field{"sample_rate", "1/s", "range samples", 1.0, 1e5});
    visit(self.joint_rate, Field{"joint_rate", "1/s", "joint readings", 1.0, 1e5});
    visit(self.seed, Field{"seed", "", "of all random errors", 0, 2147483647});
  }
};

/// How much of the raster the sensor could see: what an operator would see on its display.
struct RangeEvidence {
  std::size_t samples = 0;
  std::size_t too_near = 0;  ///< nearer than the measuring range
  std::size_t too_far = 0;   ///< farther than the measuring range
  std::size_t nothing = 0;   ///< no surface at all on the beam
  double nearest = 0.0;      ///< least distance of a surface on the beam [m]
  double farthest = 0.0;     ///< largest [m]; both 0 when there is none
};

struct EmulatedScan {
  scan::SampleLog log;
  RangeEvidence range;
  int rows = 0;
  double duration = 0.0;  ///< [s]
};

/// Scans `scene` (in workpiece coordinates) over `rectangle` of the workpiece's x-y plane [m]: joints along the raster
/// by inverse kinematics, true sensor pose by forward kinematics plus drift, ray cast, voltage, counts. Times lie on
/// a 1 us grid and begin at 0. Nothing of the truth leaves this function but the log. The same bytes with any number
/// of threads. Throws InputError for options out of range, naming the option, and for a raster the robot cannot
/// follow, naming row, pose and joint. A million samples of the S part take about 1 s.
EmulatedScan emulateScan(const geometry::Surface& scene, const Eigen::AlignedBox2d& rectangle,
                         const Frame& T_base_workpiece, const robot::Robot& robot, const robot::Encoders& encoders,
                         const PointLaserOptions& laser, const Frame& T_tip_sensor, const EmulationOptions& options,
                         int threads = 1, const Progress& progress = {});

}  // namespace scan_to_path::sensing
