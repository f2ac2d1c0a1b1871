// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace scan_to_path::geometry {

/// Height and its partial derivatives at one place.
struct HeightJet {
  double z = 0.0;  ///< [m]
  double zx = 0.0;
  double zy = 0.0;
  double zxx = 0.0;  ///< [1/m]
  double zxy = 0.0;  ///< [1/m]
  double zyy = 0.0;  ///< [1/m]
};

}  // namespace scan_to_path::geometry
