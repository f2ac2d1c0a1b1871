// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pcl/memory.h>
#include <pcl/pcl_macros.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>
#include <pcl/types.h>

#include <cstdint>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::scan {

/// One measured point. Points of a cloud are in the order in which they were measured.
struct EIGEN_ALIGN16 ScanPoint {
  PCL_ADD_POINT4D;     ///< x, y, z [m] in the cloud's frame
  std::uint32_t line;  ///< scan line the point lies on; no_line when not known
  double time;         ///< [s] since the cloud's header stamp
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

constexpr std::uint32_t no_line = 0xffffffffU;

/// What the accumulated scan is exchanged as, inside the core and between nodelets.
using ScanCloud = pcl::PointCloud<ScanPoint>;

}  // namespace scan_to_path::scan

POINT_CLOUD_REGISTER_POINT_STRUCT(scan_to_path::scan::ScanPoint,
                                  (float, x, x)(float, y, y)(float, z, z)(std::uint32_t, line, line)(double, time,
                                                                                                     time))
