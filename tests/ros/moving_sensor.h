// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <scan_to_path/ScanSamples.h>
#include <tf2_eigen/tf2_eigen.h>

#include <cmath>
#include <string>
#include <vector>

#include "scan_to_path/geometry/frames.h"

namespace scan_to_path_ros::test {

using scan_to_path::geometry::Frame;
using scan_to_path::geometry::Vector3;

/// A sensor on a link that moves straight at 0.1 m/s and turns about z at 0.5 rad/s: between any two instants exactly
/// what tf2 interpolates (straight, and slerp about a fixed axis).
struct MovingSensor {
  static constexpr double begin = 100.0;  ///< stamp of t = 0 [s]

  static ros::Time stamp(double t) {
    return ros::Time(0).fromNSec(static_cast<std::uint64_t>(std::llround((begin + t) * 1e9)));
  }

  static Frame linkAt(double t) {
    Frame T = Frame::Identity();
    T.translation() = Vector3(0.1 * t, 0.2, 0.9);
    T.linear() = Eigen::AngleAxisd(0.5 * t, Vector3::UnitZ()).toRotationMatrix();
    return T;
  }
  /// The sensor looks down, beside the link's axis.
  static Frame mount() {
    Frame T = Frame::Identity();
    T.translation() = Vector3(0.05, -0.02, -0.1);
    T.linear() = Eigen::AngleAxisd(3.14159265358979323846, Vector3::UnitX()).toRotationMatrix();
    return T;
  }
  static Vector3 pointAt(double t, double range) { return linkAt(t) * mount() * Vector3(0.0, 0.0, range); }

  static geometry_msgs::TransformStamped transform(const Frame& T, const std::string& parent, const std::string& child,
                                                   double t) {
    geometry_msgs::TransformStamped msg = tf2::eigenToTransform(T);
    msg.header.stamp = stamp(t);
    msg.header.frame_id = parent;
    msg.child_frame_id = child;
    return msg;
  }
  static geometry_msgs::TransformStamped linkTransform(double t) {
    return transform(linkAt(t), "base_link", "link", t);
  }
  static geometry_msgs::TransformStamped mountTransform() { return transform(mount(), "link", "sensor", 0.0); }

  static scan_to_path::ScanSamples samples(double t, const std::vector<double>& offsets,
                                           const std::vector<double>& ranges) {
    scan_to_path::ScanSamples msg;
    msg.header.stamp = stamp(t);
    msg.header.frame_id = "sensor";
    msg.time_offset = offsets;
    msg.range = ranges;
    return msg;
  }
  static scan_to_path::ScanSamples sample(double t, double range) { return samples(t, {0.0}, {range}); }
};

}  // namespace scan_to_path_ros::test
