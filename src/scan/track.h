// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scan_to_path/scan/sample_rows.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path::scan {

using Vector2 = Eigen::Vector2d;

/// All finite samples in measured order, in a frame whose z is against the beam.
struct Track {
  std::vector<double> x, y, z;
  std::vector<std::uint32_t> index;

  Vector2 at(std::size_t i) const { return {x[i], y[i]}; }
  std::size_t size() const { return x.size(); }
};

/// Samples begin … end of the track between two cuts.
struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The cloud's finite points, and of a cloud that knows its lines those on a line. Adds "not finite" and "no line" to
/// `dropped`; throws InputError when fewer than four points are left.
Track makeTrack(const ScanCloud& cloud, const Frame& T_beam_cloud, bool lines_given, std::vector<Dropped>& dropped);

/// Median distance between successive samples that do move [m].
double medianSpacing(const Track& track);

/// Middle of the bounding box.
Vector3 middle(const Track& track);

/// Turns the track so that `axis` (unit) becomes x.
void rotate(Track& track, const Vector2& axis);

/// Cuts where a step [m] or a silence [s] is longer, or where the cloud's line changes.
std::vector<Stretch> cutTrack(const ScanCloud& cloud, const Track& track, double longest_step, double longest_silence);

}  // namespace scan_to_path::scan
