// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/joint_readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {
namespace {

constexpr double half_counter = 2147483648.0;  // 2^31

std::string readingName(std::size_t reading) { return "joint reading " + std::to_string(reading); }

void checkReadings(const scan::SampleLog& log) {
  const std::size_t joints = log.joint_names.size();
  if (log.counts.size() != log.joint_time.size() * joints) {
    throw InputError("sample log", "number of counts", std::to_string(log.counts.size()),
                     std::to_string(joints) + " for each of " + std::to_string(log.joint_time.size()) + " readings");
  }
  for (std::size_t i = 0; i < log.joint_time.size(); ++i) {
    const double t = log.joint_time[i];
    if (!std::isfinite(t) || (i > 0 && !(t > log.joint_time[i - 1]))) {
      throw InputError(readingName(i), "time", fixed(t, 6) + " s", "finite and after the reading before it");
    }
  }
  for (std::size_t k = 0; k < log.counts.size(); ++k) {
    if (!std::isfinite(log.counts[k])) {
      throw InputError(readingName(k / joints), "count of " + log.joint_names[k % joints], fixed(log.counts[k], 0),
                       "finite");
    }
  }
}

}  // namespace

JointReadings::JointReadings(const scan::SampleLog& log, const robot::Robot& robot, const robot::Encoders& encoders,
                             double max_gap)
    : log_(log), encoders_(encoders), max_gap_(max_gap), counts_(log.counts.data()) {
  checkReadings(log);
  mapJoints(robot);
  unwrap();
}

void JointReadings::mapJoints(const robot::Robot& robot) {
  const auto& names = log_.joint_names;
  for (const auto& joint : robot.joints) {
    const auto found = std::find(names.begin(), names.end(), joint.name);
    if (found == names.end()) {
      const std::string nearest = nearestWord(joint.name, names);
      throw InputError("sample log: no column for joint " + joint.name + " of robot " + robot.name +
                       (nearest.empty() ? "" : ", the nearest column is " + nearest));
    }
    column_.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  if (names.size() != column_.size()) {
    throw InputError("sample log", "number of joints", std::to_string(names.size()),
                     std::to_string(column_.size()) + ", those of robot " + robot.name);
  }
}

void JointReadings::unwrap() {
  const std::size_t joints = column_.size();
  const auto& counts = log_.counts;
  const auto wraps = [joints](const double* now) { return std::abs(now[0] - *(now - joints)) > half_counter; };
  std::size_t first = joints;
  while (first < counts.size() && !wraps(&counts[first])) ++first;
  if (first >= counts.size()) return;  // the common case: no copy
  unwrapped_ = counts;
  for (std::size_t k = first; k < counts.size(); ++k) {
    unwrapped_[k] = robot::unwrapCount(unwrapped_[k - joints], counts[k]);
  }
  counts_ = unwrapped_.data();
}

bool JointReadings::bracket(double time, std::size_t& cursor) const {
  const auto& times = log_.joint_time;
  if (times.empty() || !(time >= times.front() && time <= times.back())) return false;
  if (cursor >= times.size() || times[cursor] > time) cursor = 0;
  if (cursor + 2 < times.size() && times[cursor + 2] <= time) {
    cursor = static_cast<std::size_t>(std::upper_bound(times.begin() + cursor, times.end(), time) - times.begin()) - 1;
  } else if (cursor + 1 < times.size() && times[cursor + 1] <= time) {
    ++cursor;
  }
  return true;
}

JointReadings::Weights JointReadings::weightsAt(double time, std::size_t cursor) const {
  const double* t = &log_.joint_time[cursor];
  const double h = t[1] - t[0];
  const bool has_left = cursor > 0 && t[0] - t[-1] <= max_gap_;
  const bool has_right = cursor + 2 < log_.joint_time.size() && t[2] - t[1] <= max_gap_;
  const double h_left = has_left ? t[0] - t[-1] : 1.0;
  const double h_right = has_right ? t[2] - t[1] : 1.0;
  const double u = (time - t[0]) / h;
  const double slope_begin = u * (1.0 - u) * (1.0 - u) * h;  // Hermite basis, times the interval
  const double slope_end = u * u * (u - 1.0) * h;

  // Slopes at both ends as multiples of the chords' slopes: left of, between and right of the two readings.
  double chord_left = 0.0;
  double chord_right = 0.0;
  double chord = slope_begin + slope_end;
  const auto blend = [&chord](double weight, double own, double other, double& chord_other, bool inner) {
    const double share = inner ? own / (own + other) : -own / (own + other);
    chord_other += weight * share;
    chord -= weight * share;
  };
  if (has_left) {
    blend(slope_begin, h, h_left, chord_left, true);
  } else if (has_right) {
    blend(slope_begin, h, h_right, chord_right, false);
  }
  if (has_right) {
    blend(slope_end, h, h_right, chord_right, true);
  } else if (has_left) {
    blend(slope_end, h, h_left, chord_left, false);
  }
  const double end_share = u * u * (3.0 - 2.0 * u);
  return {{-chord_left / h_left, 1.0 - end_share + chord_left / h_left - chord / h,
           end_share + chord / h - chord_right / h_right, chord_right / h_right}};
}

robot::JointVector JointReadings::anglesOf(std::size_t reading) const {
  std::array<double, 8> counts{};
  for (std::size_t k = 0; k < column_.size(); ++k) counts[k] = row(reading)[column_[k]];
  return encoders_.angles(counts.data());
}

JointReadings::Status JointReadings::anglesAt(double time, std::size_t& cursor, robot::JointVector& angles) const {
  if (!bracket(time, cursor)) return Status::outside;
  const std::size_t joints = column_.size();
  std::array<double, 8> counts{};
  const double* at = row(cursor);
  if (time == log_.joint_time[cursor]) {
    for (std::size_t k = 0; k < joints; ++k) counts[k] = at[column_[k]];
  } else {
    if (log_.joint_time[cursor + 1] - log_.joint_time[cursor] > max_gap_) return Status::gap;
    const Weights w = weightsAt(time, cursor);
    const double* before = cursor > 0 ? at - joints : at;
    const double* next = at + joints;
    const double* after = cursor + 2 < log_.joint_time.size() ? next + joints : next;
    for (std::size_t k = 0; k < joints; ++k) {
      const std::size_t c = column_[k];
      counts[k] = w.value[0] * before[c] + w.value[1] * at[c] + w.value[2] * next[c] + w.value[3] * after[c];
    }
  }
  angles = encoders_.angles(counts.data());
  return Status::found;
}

}  // namespace scan_to_path::sensing
