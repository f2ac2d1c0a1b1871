// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/joint_jumps.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/parallel.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {
namespace {

constexpr std::size_t window = 5;                 // readings on either side
constexpr double stamp_error = 5e-4;              // [s]
constexpr double largest_acceleration = 10.0;     // [rad/s^2]
constexpr double counts_off = 4.0;                // both readings by one and a half, and rounding
constexpr std::size_t readings_at_a_time = 8192;  // readings; fixed, so that blocks do not depend on threads

struct Jump {
  std::size_t reading = 0;
  int joint = 0;
  double size = 0.0;  // [rad]
};

class JumpFinder {
public:
  JumpFinder(const JointReadings& readings, const std::vector<double>& one_count, double limit, double max_gap)
      : readings_(readings), one_count_(one_count), limit_(limit), max_gap_(max_gap) {}

  /// The first jump that leads to one of the readings [begin, end).
  bool find(std::size_t begin, std::size_t end, Jump& jump) const {
    const std::size_t first = begin < window ? 0 : begin - window;
    const std::size_t last = std::min(readings_.size(), end + window);
    std::vector<robot::JointVector> angles;
    for (std::size_t i = first; i < last; ++i) angles.push_back(readings_.anglesOf(i));
    for (std::size_t i = std::max<std::size_t>(begin, 1); i < end; ++i) {
      if (readings_.timeOf(i) - readings_.timeOf(i - 1) > max_gap_) continue;
      if (isJump(angles, first, i, jump)) return true;
    }
    return false;
  }

private:
  /// The farthest reading from i in one direction without a gap, at most `window` - 1 away.
  std::size_t reach(std::size_t i, std::size_t first, std::size_t last, bool forward) const {
    std::size_t at = i;
    for (std::size_t k = 1; k < window && (forward ? at + 1 < last : at > first); ++k) {
      const std::size_t next = forward ? at + 1 : at - 1;
      if (std::abs(readings_.timeOf(next) - readings_.timeOf(at)) > max_gap_) break;
      at = next;
    }
    return at;
  }

  bool isJump(const std::vector<robot::JointVector>& angles, std::size_t first, std::size_t i, Jump& jump) const {
    const std::size_t before = reach(i - 1, first, first + angles.size(), false);
    const std::size_t after = reach(i, first, first + angles.size(), true);
    if (before == i - 1 && after == i) return false;
    const double dt = readings_.timeOf(i) - readings_.timeOf(i - 1);
    const double time_before = readings_.timeOf(i - 1) - readings_.timeOf(before);
    const double time_after = readings_.timeOf(after) - readings_.timeOf(i);
    const double bend = 0.5 * largest_acceleration * dt * std::max(time_before, time_after);
    for (int k = 0; k < angles.front().size(); ++k) {
      const auto angle = [&](std::size_t reading) { return angles[reading - first][k]; };
      double low = std::numeric_limits<double>::infinity(), high = -low;
      if (before < i - 1) low = high = (angle(i - 1) - angle(before)) / time_before;
      if (after > i) {
        const double speed = (angle(after) - angle(i)) / time_after;
        low = std::min(low, speed);
        high = std::max(high, speed);
      }
      const double step = angle(i) - angle(i - 1);
      const double unexplained = std::max({step - high * dt, low * dt - step, 0.0});
      const double slack = bend + stamp_error * std::max(std::abs(low), std::abs(high)) +
                           counts_off * one_count_[static_cast<std::size_t>(k)];
      if (unexplained <= limit_ + slack) continue;
      jump = {i, k, step};
      return true;
    }
    return false;
  }

  const JointReadings& readings_;
  const std::vector<double>& one_count_;
  double limit_;
  double max_gap_;
};

}  // namespace

void checkJointJumps(const JointReadings& readings, const robot::Robot& robot, const std::vector<double>& one_count,
                     double limit, double max_gap, int threads, const Progress& progress) {
  const JumpFinder finder(readings, one_count, limit, max_gap);
  const std::size_t blocks = (readings.size() + readings_at_a_time - 1) / readings_at_a_time;
  std::vector<Jump> jumps(blocks);
  std::vector<char> found(blocks, 0);
  parallelFor(blocks, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      progress.checkCancelled();
      found[b] = finder.find(b * readings_at_a_time, std::min(readings.size(), (b + 1) * readings_at_a_time), jumps[b])
                     ? 1
                     : 0;
    }
  });
  const auto first = std::find(found.begin(), found.end(), 1);
  if (first == found.end()) return;
  const Jump& jump = jumps[static_cast<std::size_t>(first - found.begin())];
  throw InputError(
      "joint reading " + std::to_string(jump.reading) + " at " + fixed(readings.timeOf(jump.reading), 6) +
      " s: " + robot.joints[static_cast<std::size_t>(jump.joint)].name + " jumps by " + fixed(jump.size, 6) +
      " rad, which its motion before and after does not explain (limit " + fixed(limit, 6) +
      " rad, scan.placement.max_joint_jump): lost counts, a slipped coupling, a new home position or a bad "
      "reading");
}

}  // namespace scan_to_path::sensing
