// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <cstdio>
#include <vector>

#include "figure_messages.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path_ros/conversions.h"
#include "scan_to_path_ros/parameters.h"

namespace scan_to_path::tools {
namespace {

// Colours that stay apart for the colour-blind (Okabe and Ito's palette) and in grey.
constexpr Colour blue = {0.00F, 0.45F, 0.70F};
constexpr Colour vermilion = {0.84F, 0.37F, 0.00F};
constexpr Colour green = {0.00F, 0.62F, 0.45F};
constexpr Colour dark = {0.25F, 0.25F, 0.28F};

constexpr double arrow_length = 0.011;    // [m]
constexpr double outline_width = 0.002;   // [m]
constexpr double ball_diameter = 0.0036;  // [m] of the spheres that mark the played-back path
constexpr double ball_spacing = 0.008;    // [m]
constexpr double tool_diameter = 0.010;   // [m]

// The detail of the fit is shown in a frame of its own, a metre for a millimetre along the row, and off it a metre for
// four micrometres.
constexpr char detail_frame[] = "fit_detail";
constexpr double detail_along = 1e3;
constexpr double detail_across = 2.5e5;

std::vector<Vector3> magnified(std::vector<Vector3> points) {
  for (Vector3& p : points) p = p.cwiseProduct(Vector3(detail_along, detail_across, detail_across));
  return points;
}

/// Those that are at least `spacing` from the one before.
std::vector<Vector3> spacedOut(const std::vector<Vector3>& points, double spacing) {
  std::vector<Vector3> kept;
  for (const Vector3& p : points) {
    if (kept.empty() || (p - kept.back()).norm() >= spacing) kept.push_back(p);
  }
  return kept;
}

class Publisher {
public:
  explicit Publisher(ros::NodeHandle& nodes) : nodes_(nodes) {}

  /// Latched: rviz may come any time later.
  template <class Message>
  void publish(const std::string& topic, const Message& message) {
    publishers_.push_back(nodes_.advertise<Message>(topic, 1, true));
    publishers_.back().publish(message);
  }

private:
  ros::NodeHandle& nodes_;
  std::vector<ros::Publisher> publishers_;
};

void publishClouds(const FigureData& data, const std::string& base, Publisher& publisher) {
  publisher.publish("raw_cloud", toCloud(data.raw, base));
  publisher.publish("filtered_cloud", toCloud(data.filtered, base));
  publisher.publish("outline", toOutline(data.outline, outline_width, vermilion, base));
  publisher.publish("detail/samples", toCloud(magnified(data.detail.samples), detail_frame));
  publisher.publish("detail/fitted_curve", toPath(magnified(data.detail.curve), detail_frame));
}

void publishNormals(const NormalComparison& normals, const std::string& base, Publisher& publisher) {
  std::vector<Vector3> origins;
  std::vector<Vector3> directions;
  for (const std::size_t i : normals.chosen) {
    origins.push_back(normals.points[i]);
    directions.push_back(normals.normals[i]);
  }
  publisher.publish("fitted_points", toCloud(normals.points, normals.normals, base));
  publisher.publish("normals", toArrows(origins, directions, arrow_length, green, base));
  publisher.publish("pca_normals", toArrows(origins, normals.pca_normals, arrow_length, vermilion, base));
}

void publishRow(const FigureData& data, const std::string& base, Publisher& publisher) {
  publisher.publish("planned_row", toPath(data.row.planned, base));
  publisher.publish("played_back_row", toPath(data.row.played_back, base));
  publisher.publish("played_back_points",
                    toSpheres(spacedOut(data.row.played_back, ball_spacing), ball_diameter, blue, base));
  publisher.publish("tool", toTool(data.cell.T_tip_tcp.translation().z() - 0.5 * tool_diameter, tool_diameter, dark,
                                   data.options.cell.tip_link));
}

/// What a cell's own nodelets publish of a job, as rviz/cell.rviz shows it.
void publishJob(const FigureData& data, const std::string& base, Publisher& publisher) {
  std_msgs::Header header;
  header.frame_id = base;
  publisher.publish("scan_cloud", toCloud(data.raw, base));
  publisher.publish("tool_path", scan_to_path_ros::toMsg(data.path.planned.path, header));
  publisher.publish("motion_plan", scan_to_path_ros::toMsg(data.motion, header));
}

std::vector<geometry_msgs::TransformStamped> cellFrames(const FigureData& data, const std::string& urdf) {
  const auto& cell = data.options.cell;
  auto frames = linkFrames(urdf, data.cell.robot, data.row.joints);
  frames.push_back(toTransform(data.cell.T_tip_sensor, cell.tip_link, "sensor"));
  frames.push_back(toTransform(data.cell.T_tip_tcp, cell.tip_link, "tcp"));
  frames.push_back(toTransform(data.cell.T_base_workpiece, cell.base_link, "workpiece"));
  frames.push_back(toTransform(Frame::Identity(), "workpiece", detail_frame));
  return frames;
}

void run() {
  ros::NodeHandle nodes;
  ros::NodeHandle own("~");
  const auto path = scan_to_path_ros::packagePath();
  const auto options = scan_to_path_ros::readJobOptions(nodes);
  const auto data = makeFigureData(options, path, own.param("seed", 1), own.param("threads", 0));
  const std::string urdf = pipeline::resolveFile(options.cell.robot, path).string();
  nodes.setParam("robot_description", readFile(urdf));
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(cellFrames(data, urdf));
  Publisher publisher(nodes);
  publishClouds(data, options.cell.base_link, publisher);
  publishNormals(data.normals, options.cell.base_link, publisher);
  publishRow(data, options.cell.base_link, publisher);
  publishJob(data, options.cell.base_link, publisher);
  ros::spin();
}

}  // namespace
}  // namespace scan_to_path::tools

/// Publishes, once and latched, what the figures in rviz/ show: the stages of one job on an emulated scan of the S
/// part.
int main(int argc, char** argv) {
  ros::init(argc, argv, "figure_scene");
  try {
    scan_to_path::tools::run();
  } catch (const scan_to_path::InputError& error) {
    std::fprintf(stderr, "figure_scene: %s\n", error.what());
    return 2;
  }
  return 0;
}
