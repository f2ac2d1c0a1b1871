// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "track.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "keep_samples.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/median.h"

namespace scan_to_path::scan {
namespace {

Track project(const ScanCloud& cloud, const Frame& T_beam_cloud) {
  Track track;
  track.x.reserve(cloud.size());
  track.y.reserve(cloud.size());
  track.z.reserve(cloud.size());
  track.index.reserve(cloud.size());
  const Eigen::Matrix3d R = T_beam_cloud.linear();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const ScanPoint& p = cloud[i];
    const Vector3 q = R * Vector3(p.x, p.y, p.z);
    if (!std::isfinite(q.sum())) continue;
    track.x.push_back(q.x());
    track.y.push_back(q.y());
    track.z.push_back(q.z());
    track.index.push_back(static_cast<std::uint32_t>(i));
  }
  return track;
}

}  // namespace

Track makeTrack(const ScanCloud& cloud, const Frame& T_beam_cloud, bool lines_given, std::vector<Dropped>& dropped) {
  Track track = project(cloud, T_beam_cloud);
  addDropped(dropped, "not finite", cloud.size() - track.size());
  if (lines_given) {
    addDropped(dropped, "no line",
               keepSamples(track, [&](std::size_t i) { return cloud[track.index[i]].line != no_line; }));
  }
  if (track.size() < 4) {
    throw InputError("scan cloud", "number of finite points on lines", std::to_string(track.size()), "at least 4");
  }
  return track;
}

double medianSpacing(const Track& track) {
  constexpr std::size_t wanted = 20000;
  const std::size_t stride = std::max<std::size_t>(1, track.size() / wanted);
  std::vector<double> steps;
  for (std::size_t i = 1; i < track.size(); i += stride) {
    const double step = (track.at(i) - track.at(i - 1)).norm();
    if (step > 0.0) steps.push_back(step);
  }
  return median(std::move(steps));
}

Vector3 middle(const Track& track) {
  const auto centre = [](const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return 0.5 * (*low + *high);
  };
  return {centre(track.x), centre(track.y), centre(track.z)};
}

void rotate(Track& track, const Vector2& axis) {
  for (std::size_t i = 0; i < track.size(); ++i) {
    const Vector2 p = track.at(i);
    track.x[i] = axis.x() * p.x() + axis.y() * p.y();
    track.y[i] = axis.x() * p.y() - axis.y() * p.x();
  }
}

std::vector<Stretch> cutTrack(const ScanCloud& cloud, const Track& track, double longest_step, double longest_silence) {
  std::vector<Stretch> stretches;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= track.size(); ++i) {
    bool cut = i == track.size();
    if (!cut) {
      const ScanPoint& p = cloud[track.index[i - 1]];
      const ScanPoint& q = cloud[track.index[i]];
      cut = (track.at(i) - track.at(i - 1)).squaredNorm() > longest_step * longest_step ||
            std::abs(q.time - p.time) > longest_silence || q.line != p.line;
    }
    if (!cut) continue;
    stretches.push_back({begin, i});
    begin = i;
  }
  return stretches;
}

}  // namespace scan_to_path::scan
