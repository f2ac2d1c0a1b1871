// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "figure_messages.h"

#include <pcl/point_types.h>
#include <pcl_conversions/pcl_conversions.h>
#include <tf2_eigen/tf2_eigen.h>
#include <urdf/model.h>

#include <cmath>
#include <kdl_parser/kdl_parser.hpp>

#include "scan_to_path/common/error.h"
#include "scan_to_path/robot/kdl_chain.h"
#include "scan_to_path_ros/conversions.h"

namespace scan_to_path::tools {
namespace {

constexpr std::size_t max_line_points = 16384;  // of rviz's line markers

template <class Point>
sensor_msgs::PointCloud2 toMessage(const pcl::PointCloud<Point>& cloud, const std::string& frame) {
  sensor_msgs::PointCloud2 msg;
  pcl::toROSMsg(cloud, msg);
  msg.header.frame_id = frame;
  return msg;
}

visualization_msgs::Marker marker(int type, int id, const Colour& colour, const std::string& frame) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;
  marker.id = id;
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.color.r = colour.r;
  marker.color.g = colour.g;
  marker.color.b = colour.b;
  marker.color.a = 1.0F;
  return marker;
}

void addTriangle(const Vector3& a, const Vector3& b, const Vector3& c, std::vector<geometry_msgs::Point>& triangles) {
  for (const Vector3& corner : {a, b, c}) triangles.push_back(scan_to_path_ros::toPoint(corner));
}

/// A frustum from `bottom` (radius r) to `top` (radius s) with the bottom closed; a cone where s is 0.
void addFrustum(const Vector3& bottom, double r, const Vector3& top, double s,
                std::vector<geometry_msgs::Point>& triangles) {
  constexpr int sides = 8;
  const Vector3 axis = (top - bottom).normalized();
  const Vector3 u = axis.unitOrthogonal();
  const Vector3 v = axis.cross(u);
  for (int i = 0; i < sides; ++i) {
    const double from = 2.0 * M_PI * i / sides;
    const double to = 2.0 * M_PI * (i + 1) / sides;
    const Vector3 a = std::cos(from) * u + std::sin(from) * v;
    const Vector3 b = std::cos(to) * u + std::sin(to) * v;
    addTriangle(bottom + r * a, bottom + r * b, top + s * b, triangles);
    if (s > 0.0) addTriangle(bottom + r * a, top + s * b, top + s * a, triangles);
    addTriangle(bottom + r * b, bottom + r * a, bottom, triangles);
  }
}

}  // namespace

sensor_msgs::PointCloud2 toCloud(const std::vector<Vector3>& points, const std::string& frame) {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const auto& p : points) {
    cloud.push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
  }
  return toMessage(cloud, frame);
}

sensor_msgs::PointCloud2 toCloud(const scan::ScanCloud& cloud, const std::string& frame) {
  return toMessage(cloud, frame);
}

sensor_msgs::PointCloud2 toCloud(const std::vector<Vector3>& points, const std::vector<Vector3>& normals,
                                 const std::string& frame) {
  pcl::PointCloud<pcl::PointNormal> cloud;
  for (std::size_t i = 0; i < points.size(); ++i) {
    pcl::PointNormal point;
    point.getVector3fMap() = points[i].cast<float>();
    point.getNormalVector3fMap() = normals[i].cast<float>();
    cloud.push_back(point);
  }
  return toMessage(cloud, frame);
}

nav_msgs::Path toPath(const std::vector<Vector3>& points, const std::string& frame) {
  std::vector<Frame> poses(points.size(), Frame::Identity());
  for (std::size_t i = 0; i < points.size(); ++i) poses[i].translation() = points[i];
  return toPath(poses, frame);
}

nav_msgs::Path toPath(const std::vector<Frame>& poses, const std::string& frame) {
  nav_msgs::Path path;
  path.header.frame_id = frame;
  for (const Frame& T : poses) {
    path.poses.emplace_back();
    path.poses.back().header.frame_id = frame;
    path.poses.back().pose = scan_to_path_ros::toPose(T);
  }
  return path;
}

visualization_msgs::MarkerArray toOutline(const std::vector<std::vector<Vector3>>& polygons, double width,
                                          const Colour& colour, const std::string& frame) {
  visualization_msgs::MarkerArray array;
  for (const auto& polygon : polygons) {
    if (polygon.size() >= max_line_points) {
      throw InputError("outline", "number of points", std::to_string(polygon.size()),
                       "below " + std::to_string(max_line_points));
    }
    auto line = marker(visualization_msgs::Marker::LINE_STRIP, static_cast<int>(array.markers.size()), colour, frame);
    line.scale.x = width;
    for (const auto& p : polygon) line.points.push_back(scan_to_path_ros::toPoint(p));
    if (!polygon.empty()) line.points.push_back(line.points.front());
    array.markers.push_back(std::move(line));
  }
  return array;
}

visualization_msgs::MarkerArray toArrows(const std::vector<Vector3>& origins, const std::vector<Vector3>& directions,
                                         double length, const Colour& colour, const std::string& frame) {
  const double shaft = 0.04 * length;
  const double head = 0.12 * length;
  auto arrows = marker(visualization_msgs::Marker::TRIANGLE_LIST, 0, colour, frame);
  arrows.scale.x = arrows.scale.y = arrows.scale.z = 1.0;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const Vector3 neck = origins[i] + 0.65 * length * directions[i];
    addFrustum(origins[i], shaft, neck, shaft, arrows.points);
    addFrustum(neck, head, origins[i] + length * directions[i], 0.0, arrows.points);
  }
  visualization_msgs::MarkerArray array;
  array.markers.push_back(std::move(arrows));
  return array;
}

visualization_msgs::MarkerArray toSpheres(const std::vector<Vector3>& points, double diameter, const Colour& colour,
                                          const std::string& frame) {
  auto spheres = marker(visualization_msgs::Marker::SPHERE_LIST, 0, colour, frame);
  spheres.scale.x = spheres.scale.y = spheres.scale.z = diameter;
  for (const auto& p : points) spheres.points.push_back(scan_to_path_ros::toPoint(p));
  visualization_msgs::MarkerArray array;
  array.markers.push_back(std::move(spheres));
  return array;
}

visualization_msgs::MarkerArray toTool(double length, double diameter, const Colour& colour, const std::string& frame) {
  auto shaft = marker(visualization_msgs::Marker::CYLINDER, 0, colour, frame);
  shaft.scale.x = shaft.scale.y = diameter;
  shaft.scale.z = length;
  shaft.pose.position.z = 0.5 * length;
  auto ball = marker(visualization_msgs::Marker::SPHERE, 1, colour, frame);
  ball.scale.x = ball.scale.y = ball.scale.z = diameter;
  ball.pose.position.z = length;
  visualization_msgs::MarkerArray array;
  array.markers = {shaft, ball};
  return array;
}

std::vector<geometry_msgs::TransformStamped> linkFrames(const std::string& urdf_file, const robot::Robot& robot,
                                                        const robot::JointVector& joints) {
  urdf::Model model;
  KDL::Tree tree;
  if (!model.initFile(urdf_file) || !kdl_parser::treeFromUrdfModel(model, tree)) {
    throw InputError(urdf_file + ": no robot that tf2 can show");
  }
  std::vector<geometry_msgs::TransformStamped> frames;
  for (const auto& [name, element] : tree.getSegments()) {
    if (name == tree.getRootSegment()->first) continue;
    double q = 0.0;
    for (int i = 0; i < robot.dof(); ++i) {
      if (robot.joints[static_cast<std::size_t>(i)].name == element.segment.getJoint().getName()) q = joints[i];
    }
    frames.push_back(toTransform(robot::fromKdl(element.segment.pose(q)), element.parent->first, name));
  }
  return frames;
}

geometry_msgs::TransformStamped toTransform(const Frame& T, const std::string& parent, const std::string& child) {
  geometry_msgs::TransformStamped msg = tf2::eigenToTransform(T);
  msg.header.frame_id = parent;
  msg.child_frame_id = child;
  return msg;
}

}  // namespace scan_to_path::tools
