// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

namespace scan_to_path::geometry {

using Vector3 = Eigen::Vector3d;

/// A rigid transform. A variable called T_a_b maps coordinates of frame b into frame a.
using Frame = Eigen::Isometry3d;

/// Translation [m] and fixed-axis roll, pitch, yaw [rad] as URDF has them: R = Rz(yaw) Ry(pitch) Rx(roll).
Frame makeFrame(const Vector3& xyz, const Vector3& rpy);

/// The frame at `origin` with the given unit z axis and its x axis as near to `x_hint` as orthogonality allows.
/// Precondition: x_hint is not parallel to z.
Frame frameFromAxes(const Vector3& origin, const Vector3& z, const Vector3& x_hint);

/// Unit quaternion of a rotation with w >= 0 (the first non-zero of x, y, z positive when w is 0), so that equal
/// rotations are written as equal numbers.
Eigen::Quaterniond canonicalQuaternion(const Eigen::Matrix3d& R);

/// The pose with its rotation turned by less than 1e-11 rad to one that comes back to the last bit after it was written
/// as a quaternion, to 12 digits or as doubles: snapped() of what was read equals what was written.
Frame snapped(const Frame& pose);

/// The unit direction of a sum, on a grid of 1e-9: it does not depend on the order in which the sum was formed.
Vector3 roundedDirection(const Vector3& sum);

/// Angle between two directions of any length [rad], exact for small angles too.
double angleBetween(const Vector3& a, const Vector3& b);

/// Rotation angle of R_a^T R_b [rad], exact for small angles too.
double rotationAngle(const Eigen::Matrix3d& R_a, const Eigen::Matrix3d& R_b);

/// Some unit vector orthogonal to `direction`.
Vector3 anyOrthogonal(const Vector3& direction);

}  // namespace scan_to_path::geometry
