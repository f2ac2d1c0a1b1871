// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/lowered_feeds.h"

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {

LoweredFeeds loweredFeeds(const toolpath::ToolPath& path, const std::vector<double>& feeds) {
  std::size_t lowered = 0;
  double least = 0.0;
  std::string at;
  auto driven = feeds.begin();
  for (const auto& segment : path.segments) {
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i, ++driven) {
      if (!(*driven < segment.waypoints[i].feed)) continue;
      if (lowered++ > 0 && *driven >= least) continue;
      least = *driven;
      at = segment.name + " waypoint " + std::to_string(i) + ", where " + fixed(segment.waypoints[i].feed, 6) +
           " m/s is asked for";
    }
  }
  LoweredFeeds found;
  found.accuracy = {{"feed_lowered", static_cast<double>(lowered), "1"}};
  if (lowered == 0) return found;
  found.accuracy.push_back({"feed_least", least, "m/s"});
  found.note = "feed lowered at " + std::to_string(lowered) + " of " + std::to_string(feeds.size()) +
               " waypoints, where a joint would be too fast: to " + fixed(least, 6) + " m/s at " + at +
               "; motion.least_feed_share=1 lets them fail instead";
  return found;
}

}  // namespace scan_to_path::pipeline
