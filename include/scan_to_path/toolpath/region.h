// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scan_to_path/geometry/frames.h"
#include "scan_to_path/toolpath/outline_clip.h"

namespace scan_to_path::toolpath {

using geometry::Frame;
using geometry::Vector3;

/// Throws InputError unless the polygon is empty or bounds something: three finite corners at least, no two of its
/// sides meeting but neighbours at their corner. `name` stands in messages. O(corners^2).
void validateRegion(const std::vector<Eigen::Vector2d>& polygon, const std::string& name);

/// What of a part is machined: all that stands over a polygon, or everything.
class Region {
public:
  Region() = default;  ///< everything

  /// `polygon` [m] in the x-y plane of its own frame, seen along that frame's z; without corners: everything.
  /// T_region_input maps the points that are asked about into that frame. Precondition: validateRegion.
  Region(std::vector<Eigen::Vector2d> polygon, const Frame& T_region_input);

  bool isEverything() const { return polygon_.empty(); }

  /// Even-odd rule; points on the border count as inside on its lower and left sides only.
  bool contains(const Vector3& p) const;

  /// The stretches of a curve inside, in rising parameter. Border crossings are looked for on the chords between the
  /// rising `parameters`, two at least, and found on the curve itself. All of it as one stretch where none is.
  /// O(parameters * corners).
  std::vector<Interval> inside(const std::function<Vector3(double)>& curve,
                               const std::vector<double>& parameters) const;

private:
  Eigen::Vector2d seen(const Vector3& p) const { return (T_region_input_ * p).head<2>(); }

  std::vector<Eigen::Vector2d> polygon_;
  Frame T_region_input_ = Frame::Identity();
};

}  // namespace scan_to_path::toolpath
