// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "figure_data.h"

/// The figures' values as standard messages. No stamps: what is shown does not change with time.
namespace scan_to_path::tools {

struct Colour {
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
};

sensor_msgs::PointCloud2 toCloud(const std::vector<Vector3>& points, const std::string& frame);
sensor_msgs::PointCloud2 toCloud(const scan::ScanCloud& cloud, const std::string& frame);

/// With the fields normal_x, normal_y, normal_z.
sensor_msgs::PointCloud2 toCloud(const std::vector<Vector3>& points, const std::vector<Vector3>& normals,
                                 const std::string& frame);

nav_msgs::Path toPath(const std::vector<Vector3>& points, const std::string& frame);
nav_msgs::Path toPath(const std::vector<Frame>& poses, const std::string& frame);

/// Closed polygons as lines of a width [m]. Throws InputError for one of more points than a line marker may have.
visualization_msgs::MarkerArray toOutline(const std::vector<std::vector<Vector3>>& polygons, double width,
                                          const Colour& colour, const std::string& frame);

/// Arrows of one length [m] as one marker of triangles, which draws hundreds of them as fast as one.
visualization_msgs::MarkerArray toArrows(const std::vector<Vector3>& origins, const std::vector<Vector3>& directions,
                                         double length, const Colour& colour, const std::string& frame);

visualization_msgs::MarkerArray toSpheres(const std::vector<Vector3>& points, double diameter, const Colour& colour,
                                          const std::string& frame);

/// A ball-nosed tool from the flange's centre to its tip: a shaft of the ball's diameter [m] along z of `frame`.
visualization_msgs::MarkerArray toTool(double length, double diameter, const Colour& colour, const std::string& frame);

/// Every link of the robot in the frame of the one before, with the given joint angles.
std::vector<geometry_msgs::TransformStamped> linkFrames(const std::string& urdf_file, const robot::Robot& robot,
                                                        const robot::JointVector& joints);

geometry_msgs::TransformStamped toTransform(const Frame& T, const std::string& parent, const std::string& child);

}  // namespace scan_to_path::tools
