// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace scan_to_path_ros {

/// The values of one type as another, one by one.
template <class Out, class In, class Convert>
std::vector<Out> converted(const std::vector<In>& in, Convert convert) {
  std::vector<Out> out;
  out.reserve(in.size());
  for (const In& value : in) out.push_back(convert(value));
  return out;
}

}  // namespace scan_to_path_ros
