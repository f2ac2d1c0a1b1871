// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/robot/robot.h"
#include "scan_to_path/sensing/raster_plan.h"

namespace scan_to_path::sensing {

/// The joint angles with which a robot carries the sensor along a raster. Inverse kinematics is solved every 2 mm;
/// between, the joints are fifth-degree polynomials of the distance: within 1 nm of the straight line, away from
/// singularities.
class RobotMotion {
public:
  /// Follows the whole raster in the first configuration that can, nearest to the middle of the joint ranges first.
  /// Throws InputError naming row, pose and joint when none can: out of reach, beyond a joint limit, or past a
  /// singularity where a joint would have to jump.
  RobotMotion(const RasterPlan& plan, const robot::Robot& robot, const Frame& T_base_workpiece,
              const Frame& T_tip_sensor, const Progress& progress = {});

  /// Joint angles [rad] on move `move` of the plan, `distance` after its start [m].
  robot::JointVector jointsAt(std::size_t move, double distance) const;

private:
  struct Move {
    std::size_t first_node;
    std::size_t nodes;
    double spacing;  // [m]
  };

  std::vector<Move> moves_;
  std::vector<robot::JointVector> nodes_;
};

}  // namespace scan_to_path::sensing
