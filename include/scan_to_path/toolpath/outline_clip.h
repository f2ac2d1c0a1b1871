// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/scan/fitted_scan.h"

namespace scan_to_path::toolpath {

struct Interval {
  double begin = 0.0;
  double end = 0.0;
};

/// Cuts parallel lines out of a part's outline. Row coordinates: t along the rows, s across, turned by `direction`
/// from the scan frame's x and y axes.
class OutlineClip {
public:
  /// `direction` of the rows in the scan plane [rad], `margin` to keep from every edge [m].
  /// Throws InputError when the outline has no polygon of three points or a point that is not finite.
  OutlineClip(const scan::Outline& outline, double direction, double margin);

  /// The stretches of the line at s that lie inside (even-odd rule), farther than the margin from every edge, by t.
  std::vector<Interval> inside(double s) const;

  double first() const { return s_min_; }  ///< least s of the outline [m]
  double last() const { return s_max_; }
  double firstT() const { return t_min_; }
  double lastT() const { return t_max_; }

private:
  struct Edge {
    Eigen::Vector2d a;  ///< (t, s)
    Eigen::Vector2d b;
  };

  std::vector<Edge> edges_;
  double margin_;
  double s_min_;
  double s_max_;
  double t_min_;
  double t_max_;
};

}  // namespace scan_to_path::toolpath
