// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/motion_jumps.h"

#include <algorithm>

#include "jump_finder.h"
#include "scan_to_path/common/parallel.h"

namespace scan_to_path::sensing {
namespace {

constexpr std::size_t readings_at_a_time = 32768;  // fixed, so that blocks do not depend on threads

}  // namespace

MotionJumps findMotionJumps(const MotionReadings& readings, const JumpLimits& limits, int threads,
                            const Progress& progress) {
  if (readings.size() < 2) return {};
  const JumpFinder finder(readings, limits);
  std::vector<MotionJumps> blocks((readings.size() + readings_at_a_time - 1) / readings_at_a_time);
  parallelFor(blocks.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      progress.checkCancelled();
      blocks[b] = finder.find(b * readings_at_a_time, std::min(readings.size(), (b + 1) * readings_at_a_time));
    }
  });
  MotionJumps jumps;
  for (auto& block : blocks) {
    if (!jumps.first) jumps.first = block.first;
    jumps.hidden.insert(jumps.hidden.end(), block.hidden.begin(), block.hidden.end());
    jumps.pauses += block.pauses;
  }
  return jumps;
}

}  // namespace scan_to_path::sensing
