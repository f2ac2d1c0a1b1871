// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "travel_direction.h"

#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::scan {
namespace {

/// Double-angle mean of the travel directions, which does not mind the sense of travel: its length is the share of
/// them that agree. With a hint only directions nearer to it than acos(least_cosine) count.
Vector2 meanDoubleAngle(const Track& track, const std::vector<Anchors>& all, const Vector2* hint = nullptr,
                        double least_cosine = 0.0) {
  Vector2 sum = Vector2::Zero();
  double weight = 0.0;
  for (const Anchors& anchors : all) {
    for (std::size_t k = 1; k < anchors.size(); ++k) {
      const Vector2 step = track.at(anchors[k]) - track.at(anchors[k - 1]);
      const double length = step.norm();
      if (length == 0.0) continue;
      if (hint != nullptr && std::abs(step.dot(*hint)) < least_cosine * length) continue;
      sum += Vector2(step.x() * step.x() - step.y() * step.y(), 2.0 * step.x() * step.y()) / length;
      weight += length;
    }
  }
  return weight > 0.0 ? Vector2(sum / weight) : Vector2(0.0, 0.0);
}

Vector2 halfAngle(const Vector2& doubled) {
  const double angle = 0.5 * std::atan2(doubled.y(), doubled.x());
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Anchors findAnchors(const Track& track, const Stretch& stretch, double window) {
  Anchors anchors{stretch.begin};
  for (std::size_t i = stretch.begin + 1; i < stretch.end; ++i) {
    if ((track.at(i) - track.at(anchors.back())).squaredNorm() >= window * window) anchors.push_back(i);
  }
  if (anchors.back() != stretch.end - 1) anchors.push_back(stretch.end - 1);
  return anchors;
}

Vector2 rowDirection(const Track& track, const std::vector<Anchors>& all) {
  const Vector2 doubled = meanDoubleAngle(track, all);
  constexpr double least_agreement = 0.2;
  if (!(doubled.norm() >= least_agreement)) {
    throw InputError("scan cloud", "share of samples travelling along one direction", fixed(doubled.norm(), 2),
                     "at least 0.20: no scan rows found; are the points in the order in which they were measured?");
  }
  Vector2 axis = halfAngle(doubled);
  for (const double least_cosine : {0.866, 0.9986}) {  // 30, 3 degrees: without the way from row to row
    const Vector2 nearer = meanDoubleAngle(track, all, &axis, least_cosine);
    if (nearer.norm() > 0.0) axis = halfAngle(nearer);
  }
  return axis;
}

}  // namespace scan_to_path::scan
