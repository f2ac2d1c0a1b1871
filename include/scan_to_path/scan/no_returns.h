// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::scan {

/// A beam that came back from nowhere within the sensor's range.
struct NoReturn {
  Eigen::Vector3f far_end = Eigen::Vector3f::Zero();  ///< of the range on the beam, in the scan cloud's frame [m]
  /// As the voltage says, or a sensor fault, which may hide anything; else too far, nothing there, or a sensor that
  /// does not tell.
  bool is_too_near = false;
};

/// The beams of a scan without a return, in the order in which they were measured.
struct NoReturns {
  std::vector<NoReturn> beams;
  double range = 0.0;    ///< length of the sensor's range along the beam [m]
  double nearest = 0.0;  ///< distance from the sensor to where the range begins [m]
};

}  // namespace scan_to_path::scan
