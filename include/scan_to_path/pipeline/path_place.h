// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include <string>

#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::pipeline {

/// Where a path works, along the axes of two frames [m]: what a look into the cell or a jog to a corner can check.
struct PathPlace {
  std::string frame;                   ///< of the path, base_link
  Eigen::AlignedBox3d in_frame;        ///< of the contacts that the process is on for
  Eigen::AlignedBox3d in_work_object;  ///< the same in the work object frame

  bool isEmpty() const { return in_frame.isEmpty(); }
};

/// Empty for a path without contacts. An air run's lift counts.
PathPlace placeOf(const toolpath::ToolPath& path, const geometry::Frame& T_base_workobject);

/// "x 0.850 to 1.090, y … m in base_link, … in the work object"; nothing for an empty one.
std::string placeText(const PathPlace& place);

}  // namespace scan_to_path::pipeline
