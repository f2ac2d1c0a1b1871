// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "scan_to_path/common/options.h"

namespace scan_to_path::toolpath {

/// What a waypoint was found to be.
enum class Verdict { ok, gouge, unreachable, joint_limit, singular, collision, speed, jump };

/// One waypoint's verdict with the evidence for it.
struct WaypointVerdict {
  int segment = 0;  ///< index into the path's segments
  int index = 0;    ///< index into the segment's waypoints
  Verdict verdict = Verdict::ok;
  double margin = 0.0;  ///< to the limit that decides, negative when broken
  std::string unit;     ///< of the margin, "rad", "rad/s", "m"
  std::string reason;   ///< e.g. "joint_4 needs 7.9 rad/s, limit 6.3"; empty when ok
  std::string remedy;   ///< what to change, e.g. "turn the part, lower the feed"; empty when ok
};

}  // namespace scan_to_path::toolpath

namespace scan_to_path {
template <>
struct EnumNames<toolpath::Verdict> {
  static constexpr std::array<const char*, 8> names = {"ok",       "gouge",     "unreachable", "joint_limit",
                                                       "singular", "collision", "speed",       "jump"};
};
}  // namespace scan_to_path
