// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/report.h"

namespace scan_to_path::pipeline {

/// What to say of moves that are driven slower than the path asks for.
struct LoweredFeeds {
  std::vector<Accuracy> accuracy;   ///< feed_lowered, the number of waypoints; with any, feed_least [m/s]
  std::optional<std::string> note;  ///< nothing when no feed is lowered
};

/// Compares the path's feeds with those that are driven, one for each waypoint in order (motion::MotionPlan::feeds).
LoweredFeeds loweredFeeds(const toolpath::ToolPath& path, const std::vector<double>& feeds);

}  // namespace scan_to_path::pipeline
