// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/conversions.h"

#include <cmath>

#include "converted.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path_ros {
namespace {

using core::InputError;
using core::geometry::Frame;
using core::geometry::Vector3;

std::vector<geometry_msgs::Point> toPoints(const std::vector<Vector3>& points) {
  return converted<geometry_msgs::Point>(points, [](const Vector3& p) { return toPoint(p); });
}

std::vector<Vector3> fromPoints(const std::vector<geometry_msgs::Point>& points) {
  return converted<Vector3>(points, [](const geometry_msgs::Point& p) { return fromPoint(p); });
}

}  // namespace

geometry_msgs::Point toPoint(const Vector3& p) {
  geometry_msgs::Point msg;
  msg.x = p.x();
  msg.y = p.y();
  msg.z = p.z();
  return msg;
}

geometry_msgs::Vector3 toVector(const Vector3& v) {
  geometry_msgs::Vector3 msg;
  msg.x = v.x();
  msg.y = v.y();
  msg.z = v.z();
  return msg;
}

Vector3 fromPoint(const geometry_msgs::Point& p) { return {p.x, p.y, p.z}; }

Vector3 fromVector(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

geometry_msgs::Pose toPose(const Frame& T) {
  const Eigen::Quaterniond q = core::geometry::canonicalQuaternion(T.linear());
  geometry_msgs::Pose pose;
  pose.position = toPoint(T.translation());
  pose.orientation.x = q.x();
  pose.orientation.y = q.y();
  pose.orientation.z = q.z();
  pose.orientation.w = q.w();
  return pose;
}

Frame fromPose(const geometry_msgs::Pose& pose, const std::string& what) {
  const Vector3 origin = fromPoint(pose.position);
  if (!origin.allFinite()) throw InputError(what + ": position is not finite");
  const Eigen::Quaterniond q(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  if (!(std::abs(q.norm() - 1.0) <= 1e-6)) {
    throw InputError(what + ": the quaternion's length is " + std::to_string(q.norm()) + ", must be 1 within 1e-6");
  }
  Frame T = Frame::Identity();
  T.linear() = q.normalized().toRotationMatrix();
  T.translation() = origin;
  return core::geometry::snapped(T);
}

core::StageReport toMsg(const core::pipeline::StageReport& report,
                        const std::vector<core::pipeline::Accuracy>& accuracy, const std::vector<std::string>& notes,
                        const std_msgs::Header& header) {
  core::StageReport msg;
  msg.header = header;
  msg.name = report.name;
  msg.samples_in = report.in;
  msg.samples_out = report.out;
  for (const auto& entry : report.dropped) {
    core::Dropped dropped;
    dropped.reason = entry.reason;
    dropped.count = entry.count;
    msg.dropped.push_back(dropped);
  }
  for (const auto& figure : accuracy) {
    core::Accuracy entry;
    entry.name = figure.name;
    entry.value = figure.value;
    entry.unit = figure.unit;
    entry.has_limit = static_cast<std::uint8_t>(figure.limit.has_value());
    entry.limit = figure.limit.value_or(0.0);
    msg.accuracy.push_back(entry);
  }
  msg.notes = notes;
  return msg;
}

core::pipeline::StageReport stageReport(const core::StageReport& msg) {
  core::pipeline::StageReport report{msg.name, msg.samples_in, msg.samples_out, {}};
  for (const auto& entry : msg.dropped) report.dropped.push_back({entry.reason, entry.count});
  return report;
}

std::vector<core::pipeline::Accuracy> accuracy(const core::StageReport& msg) {
  return converted<core::pipeline::Accuracy>(msg.accuracy, [](const core::Accuracy& entry) {
    core::pipeline::Accuracy figure{entry.name, entry.value, entry.unit};
    if (entry.has_limit != 0) figure.limit = entry.limit;
    return figure;
  });
}

core::NurbsCurve toMsg(const core::nurbs::Curve& curve) {
  core::NurbsCurve msg;
  msg.degree = curve.degree;
  msg.knots = curve.knots;
  msg.control_points = toPoints(curve.control_points);
  msg.weights = curve.weights;
  return msg;
}

core::nurbs::Curve fromMsg(const core::NurbsCurve& msg) {
  core::nurbs::Curve curve;
  curve.degree = msg.degree;
  curve.knots = msg.knots;
  curve.control_points = fromPoints(msg.control_points);
  curve.weights = msg.weights;
  core::nurbs::validate(curve);
  return curve;
}

core::NurbsSurface toMsg(const core::nurbs::Surface& surface) {
  core::NurbsSurface msg;
  msg.degree_u = surface.degree_u;
  msg.degree_v = surface.degree_v;
  msg.knots_u = surface.knots_u;
  msg.knots_v = surface.knots_v;
  msg.control_points = toPoints(surface.control_points);
  msg.weights = surface.weights;
  return msg;
}

core::nurbs::Surface fromMsg(const core::NurbsSurface& msg) {
  core::nurbs::Surface surface;
  surface.degree_u = msg.degree_u;
  surface.degree_v = msg.degree_v;
  surface.knots_u = msg.knots_u;
  surface.knots_v = msg.knots_v;
  surface.control_points = fromPoints(msg.control_points);
  surface.weights = msg.weights;
  if (!surface.control_points.empty()) core::nurbs::validate(surface);  // a scan fitted without one has none
  return surface;
}

}  // namespace scan_to_path_ros
