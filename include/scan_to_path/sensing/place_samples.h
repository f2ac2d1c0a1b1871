// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/common/progress.h"
#include "scan_to_path/robot/encoders.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/scan/no_returns.h"
#include "scan_to_path/scan/sample_log.h"
#include "scan_to_path/scan/scan_cloud.h"
#include "scan_to_path/sensing/joint_jumps.h"
#include "scan_to_path/sensing/point_laser.h"

namespace scan_to_path::sensing {

using geometry::Frame;
using geometry::Vector3;

/// How samples are placed in the robot's base frame.
struct PlacementOptions {
  std::optional<double> clock_offset;
  double max_joint_gap = 0.05;
  double max_joint_jump = 5e-5;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(
        self.clock_offset,
        Field{"clock_offset", "s",
              "calibrated, added to the sensor's time to get the encoders'; unset: not known, taken as 0", -1.0, 1.0});
    visit(self.max_joint_gap,
          Field{"max_joint_gap", "s", "a sample between joint readings farther apart is dropped", 0.0, 10.0});
    visit(self.max_joint_jump,
          Field{"max_joint_jump", "rad",
                "a larger step of a joint that its motion before and after does not explain is refused; 0: none is",
                0.0, 10.0});
  }
};

/// A scan in base_link with the beam it was taken along, and what could not be placed.
struct PlacedScan {
  scan::ScanCloud cloud;                  ///< line = no_line; time from the log's first sample
  Vector3 mean_beam = -Vector3::UnitZ();  ///< unit, the mean viewing direction in base_link
  std::size_t samples_in = 0;
  std::vector<scan::Dropped> dropped;  ///< "no return", "sensor fault", "no joint reading", …
  scan::NoReturns no_returns;          ///< of the samples without a return and the faults those whose joints are known
  UnseenJumps unseen_jumps;            ///< none when jumps are not looked for
  std::size_t times_repeated = 1;      ///< how often the log repeats each joint reading
};

/// Pulses to joint angles (interpolated to the sensor's time), forward kinematics, p_B = T_BE T_EM (0, 0, d, 1)^T
/// (seed 000 eqs. 1 and 2). Throws InputError when no sample at all can be placed (asking for another sweep where all
/// are out of the sensor's range), a joint is outside its limits
/// by more than a count, naming joint, value, sample and limit, or jumps (joint_jumps.h), or the sensor rests
/// (resting_sensor.h).
PlacedScan placeSamples(const scan::SampleLog& log, const robot::Robot& robot, const robot::Encoders& encoders,
                        const PointLaserOptions& laser, const Frame& T_tip_sensor, const PlacementOptions& options,
                        int threads = 1, const Progress& progress = {});

}  // namespace scan_to_path::sensing
