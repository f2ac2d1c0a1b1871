// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "scan_to_path/common/random.h"
#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path::test {

/// Height of what the beam meets above (x, y), looking along -z; nothing: no return.
using HeightFunction = std::function<std::optional<double>(double x, double y)>;

/// A raster scan of a height function, rows along x.
struct RasterScan {
  double x_min = -0.01;
  double x_max = 0.25;
  std::vector<double> rows;   ///< y of each row [m]
  double spacing = 50e-6;     ///< [m]
  double speed = 0.05;        ///< [m/s]
  bool zigzag = true;         ///< one-way scans jump back between rows, the sensor off
  bool turns = true;          ///< zig-zag: samples on the way from row to row
  double noise = 0.0;         ///< sigma along the beam [m]
  double clock_offset = 0.0;  ///< sensor after encoders [s]: shifts rows along their travel direction
  double spikes = 0.0;        ///< share of samples
  double spike_min = 0.0002;  ///< [m], either sign
  double spike_max = 0.005;
  double drop_outs = 0.0;  ///< share of samples
  std::uint64_t seed = 1;
  geometry::Frame T_cloud_scan = geometry::Frame::Identity();
};

inline std::vector<double> evenRows(double first, double pitch, int count) {
  std::vector<double> rows;
  for (int i = 0; i < count; ++i) rows.push_back(first + pitch * i);
  return rows;
}

/// A height field on a table below it.
inline HeightFunction onTable(const geometry::HeightField& part, double table) {
  return [&part, table](double x, double y) -> std::optional<double> {
    return part.rectangle().contains(x, y) ? part.jet(x, y).z : table;
  };
}

/// The height field alone: beside it nothing returns.
inline HeightFunction freeStanding(const geometry::HeightField& part) {
  return [&part](double x, double y) -> std::optional<double> {
    if (!part.rectangle().contains(x, y)) return std::nullopt;
    return part.jet(x, y).z;
  };
}

class RasterScanner {
public:
  RasterScanner(const RasterScan& scan, const HeightFunction& height)
      : scan_(scan), height_(height), noise_(scan.seed, 1), spikes_(scan.seed, 2), drop_outs_(scan.seed, 3) {}

  scan::ScanCloud run() {
    const auto steps = static_cast<int>(std::lround((scan_.x_max - scan_.x_min) / scan_.spacing));
    for (std::size_t r = 0; r < scan_.rows.size(); ++r) {
      const bool forward = !scan_.zigzag || r % 2 == 0;
      const double sense = forward ? 1.0 : -1.0;
      for (int k = 0; k <= steps; ++k) {
        const double along = scan_.spacing * k;
        take(forward ? scan_.x_min + along : scan_.x_max - along, scan_.rows[r], sense);
      }
      if (scan_.zigzag && scan_.turns && r + 1 < scan_.rows.size()) {
        const double x = forward ? scan_.x_max : scan_.x_min;
        const double rise = scan_.rows[r + 1] - scan_.rows[r];
        const int turn = static_cast<int>(std::abs(rise) / scan_.spacing);
        for (int k = 1; k < turn; ++k) take(x, scan_.rows[r] + rise * k / turn, 0.0);
      }
    }
    cloud_.width = static_cast<std::uint32_t>(cloud_.size());
    cloud_.height = 1;
    return std::move(cloud_);
  }

private:
  void take(double x, double y, double sense) {
    time_ += scan_.spacing / scan_.speed;
    const auto z = height_(x + sense * scan_.speed * scan_.clock_offset, y);
    double measured = z.value_or(0.0) + scan_.noise * noise_.gaussian();
    const bool spike = spikes_.uniform() < scan_.spikes;
    const double size = spikes_.uniform(scan_.spike_min, scan_.spike_max);
    if (spike) measured += spikes_.uniform() < 0.5 ? size : -size;
    const bool lost = drop_outs_.uniform() < scan_.drop_outs;
    if (!z || lost) return;
    const geometry::Vector3 p = scan_.T_cloud_scan * geometry::Vector3(x, y, measured);
    scan::ScanPoint point;
    point.x = static_cast<float>(p.x());
    point.y = static_cast<float>(p.y());
    point.z = static_cast<float>(p.z());
    point.line = scan::no_line;
    point.time = time_;
    cloud_.push_back(point);
  }

  RasterScan scan_;
  HeightFunction height_;
  Random noise_;
  Random spikes_;
  Random drop_outs_;
  double time_ = 0.0;
  scan::ScanCloud cloud_;
};

inline scan::ScanCloud scanRaster(const RasterScan& scan, const HeightFunction& height) {
  return RasterScanner(scan, height).run();
}

}  // namespace scan_to_path::test
