// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/geometry/frames.h"

#include <cmath>

namespace scan_to_path::geometry {

Frame makeFrame(const Vector3& xyz, const Vector3& rpy) {
  Frame T = Frame::Identity();
  T.linear() = (Eigen::AngleAxisd(rpy.z(), Vector3::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3::UnitY()) *
                Eigen::AngleAxisd(rpy.x(), Vector3::UnitX()))
                   .toRotationMatrix();
  T.translation() = xyz;
  return T;
}

Frame frameFromAxes(const Vector3& origin, const Vector3& z, const Vector3& x_hint) {
  Frame T = Frame::Identity();
  const Vector3 x = (x_hint - z * z.dot(x_hint)).normalized();
  T.linear().col(0) = x;
  T.linear().col(1) = z.cross(x);
  T.linear().col(2) = z;
  T.translation() = origin;
  return T;
}

Eigen::Quaterniond canonicalQuaternion(const Eigen::Matrix3d& R) {
  Eigen::Quaterniond q(R);
  q.normalize();
  const double leading = q.w() != 0.0 ? q.w() : q.x() != 0.0 ? q.x() : q.y() != 0.0 ? q.y() : q.z();
  if (leading < 0.0) q.coeffs() = -q.coeffs();
  return q;
}

Frame snapped(const Frame& pose) {
  // Three components on a grid and the largest from unit length: errors far below the grid's step change nothing. Of
  // components that are equal but for such errors the first counts as the largest.
  constexpr double steps_per_unit = 1e12;
  constexpr double equal = 1e-6;
  Eigen::Vector4d c = canonicalQuaternion(pose.linear()).coeffs();
  const double largest = c.cwiseAbs().maxCoeff();
  Eigen::Index m = 0;
  while (std::abs(c[m]) < largest - equal) ++m;
  double rest = 1.0;
  for (Eigen::Index i = 0; i < 4; ++i) {
    if (i == m) continue;
    c[i] = std::round(c[i] * steps_per_unit) / steps_per_unit + 0.0;  // no negative zero
    rest -= c[i] * c[i];
  }
  c[m] = std::copysign(std::sqrt(rest), c[m]);
  Frame T = pose;
  T.linear() = Eigen::Quaterniond(c).toRotationMatrix();
  return T;
}

Vector3 roundedDirection(const Vector3& sum) {
  constexpr double steps_per_unit = 1e9;
  return Vector3((sum.normalized() * steps_per_unit).array().round()).normalized();
}

double angleBetween(const Vector3& a, const Vector3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

double rotationAngle(const Eigen::Matrix3d& R_a, const Eigen::Matrix3d& R_b) {
  const Eigen::Quaterniond q(R_a.transpose() * R_b);
  return 2.0 * std::atan2(q.vec().norm(), std::abs(q.w()));
}

Vector3 anyOrthogonal(const Vector3& direction) { return direction.unitOrthogonal(); }

}  // namespace scan_to_path::geometry
