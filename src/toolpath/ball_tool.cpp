// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/ball_tool.h"

#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::toolpath {
namespace {

constexpr double largest_angle = 80.0 * M_PI / 180.0;

void checkAngle(const char* name, double angle) {
  if (!(std::abs(angle) <= largest_angle)) {
    throw InputError("ball tool", name, fixed(angle, 6) + " rad", "within +-" + fixed(largest_angle, 6) + " rad");
  }
}

}  // namespace

Frame ballToolFrame(const BallTool& tool) {
  if (!(tool.radius > 0.0) || !std::isfinite(tool.radius)) {
    throw InputError("ball tool", "radius", fixed(tool.radius, 6) + " m", "positive");
  }
  checkAngle("lead", tool.lead);
  checkAngle("tilt", tool.tilt);
  const Eigen::Translation3d to_centre(0.0, 0.0, tool.radius);
  const Eigen::AngleAxisd lead(tool.lead, Vector3::UnitY());
  const Eigen::AngleAxisd tilt(tool.tilt, Vector3::UnitX());
  Frame T_contact_tcp = to_centre * lead * tilt * to_centre.inverse();  // Equation (13), T_lead,tilt,offset
  Eigen::Matrix3d half_turn = Vector3(1.0, -1.0, -1.0).asDiagonal();    // Rot(x, 180 deg), exact
  T_contact_tcp.linear() = (T_contact_tcp.linear() * half_turn).eval();
  return T_contact_tcp;
}

Vector3 ballCentre(const Frame& contact, double radius) {
  return contact.translation() + radius * contact.linear().col(2);
}

}  // namespace scan_to_path::toolpath
