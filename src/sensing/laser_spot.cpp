// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/laser_spot.h"

#include <cmath>

namespace scan_to_path::sensing {
namespace {

constexpr int parts = 64;
// Departure of the rim's mean from the axis that a smooth surface does not reach [m]: curvature 1/(0.3 mm) at 50 um.
constexpr double smooth_departure = 1e-6;
constexpr double least_light = 0.5;

std::optional<double> castBeside(const geometry::Surface& scene, const geometry::Frame& T_scene_sensor,
                                 const Eigen::Vector2d& offset) {
  const geometry::Ray ray{T_scene_sensor * geometry::Vector3(offset.x(), offset.y(), 0.0),
                          T_scene_sensor.linear().col(2)};
  const auto hit = scene.castRay(ray);
  if (!hit) return std::nullopt;
  return hit->distance;
}

Eigen::Vector2d onCircle(double radius, double turn) {
  return radius * Eigen::Vector2d(std::cos(turn), std::sin(turn));
}

}  // namespace

LaserSpot::LaserSpot(double diameter, const PointLaserOptions& laser) : radius_(0.5 * diameter), laser_(laser) {
  if (radius_ == 0.0) return;
  // Vogel's sunflower: even over the disc, with no two parts in line along any edge.
  const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    const double share = (k + 0.5) / parts;  // r^2 over the radius's
    parts_.push_back({onCircle(radius_ * std::sqrt(share), golden_angle * k), std::exp(-2.0 * share)});
    sum += parts_.back().intensity;
  }
  for (auto& part : parts_) part.intensity /= sum;
}

LaserSpot::Reading LaserSpot::read(const geometry::Surface& scene, const geometry::Frame& T_scene_sensor) const {
  Reading reading;
  reading.on_axis = castBeside(scene, T_scene_sensor, Eigen::Vector2d::Zero());
  const bool is_in_range = reading.on_axis && isInRange(*reading.on_axis);
  if (radius_ == 0.0 || (is_in_range && isSmooth(scene, T_scene_sensor, *reading.on_axis))) {
    if (is_in_range) reading.distance = reading.on_axis;
  } else {
    reading.distance = meanOverSpot(scene, T_scene_sensor);
  }
  return reading;
}

bool LaserSpot::isInRange(double distance) const {
  return distance >= laser_.distance_min && distance <= laser_.distance_max;
}

bool LaserSpot::isSmooth(const geometry::Surface& scene, const geometry::Frame& T_scene_sensor, double on_axis) const {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const auto distance = castBeside(scene, T_scene_sensor, onCircle(radius_, 2.0 * M_PI * k / 3));
    if (!distance) return false;
    sum += *distance;
  }
  return std::abs(sum / 3.0 - on_axis) <= smooth_departure;
}

std::optional<double> LaserSpot::meanOverSpot(const geometry::Surface& scene,
                                              const geometry::Frame& T_scene_sensor) const {
  double light = 0.0;
  double sum = 0.0;
  for (const auto& part : parts_) {
    const auto distance = castBeside(scene, T_scene_sensor, part.offset);
    if (!distance || !isInRange(*distance)) continue;
    light += part.intensity;
    sum += part.intensity * *distance;
  }
  if (light < least_light) return std::nullopt;
  return sum / light;
}

}  // namespace scan_to_path::sensing
