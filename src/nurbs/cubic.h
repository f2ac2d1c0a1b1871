// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace scan_to_path::nurbs {

inline constexpr int degree = 3;  ///< of everything that is fitted

}  // namespace scan_to_path::nurbs
