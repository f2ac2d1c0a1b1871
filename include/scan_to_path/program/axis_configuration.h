// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/robot/robot.h"

namespace scan_to_path::program {

/// ABB's confdata: which of several joint solutions a robtarget means.
struct AxisConfiguration {
  int cf1 = 0;  ///< quadrant of axis 1
  int cf4 = 0;  ///< quadrant of axis 4
  int cf6 = 0;  ///< quadrant of axis 6
  int cfx = 0;  ///< 4 (wrist centre behind axis 1) + 2 (wrist centre behind the lower arm) + 1 (axis 5 negative)
};

/// ABB's quadrant of an axis: 0 for [0, 90) degrees, 1 for [90, 180), -1 for [-90, 0), … An angle within 1e-7 rad
/// below a boundary counts as on it, so that rounding does not decide.
int axisQuadrant(double angle);

/// The configuration of a six-axis arm with a spherical wrist whose joints turn as ABB's do (z, y, y, x, y, x at
/// zero). cfx after the table of ABB's technical reference manual for confdata; models without a turning-over arm
/// ignore it. Throws InputError for another number of joints.
AxisConfiguration axisConfiguration(const robot::Robot& robot, const robot::JointVector& q);

}  // namespace scan_to_path::program
