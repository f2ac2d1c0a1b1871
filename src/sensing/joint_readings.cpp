// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/joint_readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {
namespace {

constexpr double half_counter = 2147483648.0;  // 2^31
constexpr std::size_t longest_run = 64;        // readings; longer ones are rests
constexpr std::size_t fewest_runs = 100;       // to tell from them how long a controller holds its counts

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

/// `runs`[n]: how many runs of n equal readings there are. 1 where there are too few to tell.
std::size_t medianRun(const std::array<std::size_t, longest_run + 1>& runs) {
  const std::size_t all = std::accumulate(runs.begin(), runs.end(), std::size_t{0});
  if (all < fewest_runs) return 1;
  std::size_t length = 0;
  for (std::size_t passed = 0; 2 * passed < all; ++length) passed += runs[length + 1];
  return length;
}

}  // namespace

JointReadings::JointReadings(const scan::SampleLog& log, const robot::Robot& robot, const robot::Encoders& encoders,
                             double max_gap)
    : log_(log),
      encoders_(encoders),
      max_gap_(max_gap),
      size_(log.joint_time.size()),
      counts_(log.counts.data()),
      time_(log.joint_time.data()) {
  checkReadings(log);
  mapJoints(robot);
  unwrap();
  dropRepeated();
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
  own_counts_ = counts;
  for (std::size_t k = first; k < counts.size(); ++k) {
    own_counts_[k] = robot::unwrapCount(own_counts_[k - joints], counts[k]);
  }
  counts_ = own_counts_.data();
}

/// A run of one count at rest is longer than what a controller holds, so the median run tells how long it holds one.
void JointReadings::dropRepeated() {
  const std::size_t joints = column_.size();
  const auto isRepeated = [&](std::size_t i) { return std::equal(row(i), row(i) + joints, row(i - 1)); };
  std::array<std::size_t, longest_run + 1> runs{};  // how many there are of each length
  for (std::size_t begin = 0, i = 1; i <= size_; ++i) {
    if (i < size_ && isRepeated(i)) continue;
    ++runs[std::min(i - begin, longest_run)];
    begin = i;
  }
  repeated_ = medianRun(runs);
  if (repeated_ == 1) return;
  std::vector<double> counts;
  for (std::size_t i = 0; i < size_; ++i) {
    if (i > 0 && isRepeated(i) && i < kept_.back() + repeated_) continue;
    kept_.push_back(i);
    own_time_.push_back(time_[i]);
    counts.insert(counts.end(), row(i), row(i) + joints);
  }
  own_counts_ = std::move(counts);
  size_ = kept_.size();
  counts_ = own_counts_.data();
  time_ = own_time_.data();
}

bool JointReadings::bracket(double time, std::size_t& cursor) const {
  if (size_ == 0 || !(time >= time_[0] && time <= time_[size_ - 1])) return false;
  if (cursor >= size_ || time_[cursor] > time) cursor = 0;
  if (cursor + 2 < size_ && time_[cursor + 2] <= time) {
    cursor = static_cast<std::size_t>(std::upper_bound(time_ + cursor, time_ + size_, time) - time_) - 1;
  } else if (cursor + 1 < size_ && time_[cursor + 1] <= time) {
    ++cursor;
  }
  return true;
}

JointReadings::Weights JointReadings::weightsAt(double time, std::size_t cursor) const {
  const double* t = time_ + cursor;
  const double h = t[1] - t[0];
  const bool has_left = cursor > 0 && t[0] - t[-1] <= max_gap_;
  const bool has_right = cursor + 2 < size_ && t[2] - t[1] <= max_gap_;
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
  if (time == time_[cursor]) {
    for (std::size_t k = 0; k < joints; ++k) counts[k] = at[column_[k]];
  } else {
    if (time_[cursor + 1] - time_[cursor] > max_gap_) return Status::gap;
    const Weights w = weightsAt(time, cursor);
    const double* before = cursor > 0 ? at - joints : at;
    const double* next = at + joints;
    const double* after = cursor + 2 < size_ ? next + joints : next;
    for (std::size_t k = 0; k < joints; ++k) {
      const std::size_t c = column_[k];
      counts[k] = w.value[0] * before[c] + w.value[1] * at[c] + w.value[2] * next[c] + w.value[3] * after[c];
    }
  }
  angles = encoders_.angles(counts.data());
  return Status::found;
}

}  // namespace scan_to_path::sensing
