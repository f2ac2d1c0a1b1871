// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace scan_to_path {

inline constexpr double right_angle = 1.5707963267948966;  ///< [rad]
inline constexpr double degrees_per_radian = 57.29577951308232;

}  // namespace scan_to_path
