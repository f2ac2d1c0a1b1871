// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/sensing/point_laser.h"

namespace scan_to_path::sensing {

/// The distance a triangulation sensor sees with a spot of some size: the mean over the spot, weighted by the light
/// that comes back. On a smooth surface that is the distance on the beam's axis; on an edge it mixes both sides.
class LaserSpot {
public:
  /// What is in front of the sensor.
  struct Reading {
    std::optional<double> distance;  ///< [m]; nothing when less than half of the light comes back from within range
    std::optional<double> on_axis;   ///< of the first surface on the beam's axis, however far [m]
  };

  /// diameter: at 1/e^2 of the intensity of a Gaussian beam [m]; 0: a ray.
  LaserSpot(double diameter, const PointLaserOptions& laser);

  /// T_scene_sensor: the sensor looks along +z from its origin.
  Reading read(const geometry::Surface& scene, const geometry::Frame& T_scene_sensor) const;

private:
  struct Part {
    Eigen::Vector2d offset;  // from the axis [m]
    double intensity;        // share of the whole
  };

  bool isInRange(double distance) const;
  bool isSmooth(const geometry::Surface& scene, const geometry::Frame& T_scene_sensor, double on_axis) const;
  std::optional<double> meanOverSpot(const geometry::Surface& scene, const geometry::Frame& T_scene_sensor) const;

  double radius_;
  PointLaserOptions laser_;
  std::vector<Part> parts_;
};

}  // namespace scan_to_path::sensing
