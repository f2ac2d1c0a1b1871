// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::program {

/// A rigid transform of the reader's own, so that a slip in the writer's rotation code cannot hide in both.
struct RapidPose {
  std::array<std::array<double, 3>, 3> r{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<double, 3> t{};  ///< [m]

  /// From a unit quaternion q1 … q4 = w, x, y, z.
  static RapidPose fromQuaternion(const std::array<double, 4>& q, const std::array<double, 3>& t) {
    const auto [w, x, y, z] = q;
    RapidPose pose;
    pose.r = {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
    pose.t = t;
    return pose;
  }

  /// This transform after `inner`.
  RapidPose operator*(const RapidPose& inner) const {
    RapidPose pose;
    for (std::size_t i = 0; i < 3; ++i) {
      pose.t[i] = t[i];
      for (std::size_t j = 0; j < 3; ++j) {
        pose.t[i] += r[i][j] * inner.t[j];
        pose.r[i][j] = r[i][0] * inner.r[0][j] + r[i][1] * inner.r[1][j] + r[i][2] * inner.r[2][j];
      }
    }
    return pose;
  }

  geometry::Frame frame() const {
    geometry::Frame T = geometry::Frame::Identity();
    for (int i = 0; i < 3; ++i) {
      T.translation()[i] = t[static_cast<std::size_t>(i)];
      for (int j = 0; j < 3; ++j) T.linear()(i, j) = r[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
    return T;
  }
};

}  // namespace scan_to_path::program
