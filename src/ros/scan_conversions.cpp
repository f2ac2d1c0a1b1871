// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/conversions.h"

#include <cmath>

#include "converted.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path_ros {
namespace {

using core::InputError;

core::FittedLine toLine(const core::scan::FittedLine& line) {
  core::FittedLine msg;
  msg.row = line.row;
  msg.forward = static_cast<std::uint8_t>(line.forward);
  msg.curve = scan_to_path_ros::toMsg(line.curve);
  msg.begin = line.begin;
  msg.end = line.end;
  msg.begins_at_edge = static_cast<std::uint8_t>(line.begins_at_edge);
  msg.ends_at_edge = static_cast<std::uint8_t>(line.ends_at_edge);
  msg.samples = line.samples;
  msg.residual_rms = line.residual_rms;
  msg.sigma = line.sigma;
  return msg;
}

core::scan::FittedLine fromLine(const core::FittedLine& msg) {
  core::scan::FittedLine line;
  line.row = msg.row;
  line.forward = msg.forward != 0;
  line.curve = scan_to_path_ros::fromMsg(msg.curve);
  line.begin = msg.begin;
  line.end = msg.end;
  if (!(line.begin >= line.curve.first() && line.begin <= line.end && line.end <= line.curve.last())) {
    throw InputError("fitted line of row " + std::to_string(msg.row) + ": begin " + std::to_string(msg.begin) +
                     " and end " + std::to_string(msg.end) + " must lie in the curve's parameters, in this order");
  }
  line.begins_at_edge = msg.begins_at_edge != 0;
  line.ends_at_edge = msg.ends_at_edge != 0;
  line.samples = msg.samples;
  line.residual_rms = msg.residual_rms;
  line.sigma = msg.sigma;
  return line;
}

core::OutlinePolygon toPolygon(const std::vector<Eigen::Vector2d>& polygon) {
  core::OutlinePolygon msg;
  for (const auto& p : polygon) {
    msg.x.push_back(p.x());
    msg.y.push_back(p.y());
  }
  return msg;
}

std::vector<Eigen::Vector2d> fromPolygon(const core::OutlinePolygon& msg) {
  if (msg.x.size() != msg.y.size()) {
    throw InputError("outline: " + std::to_string(msg.x.size()) + " x and " + std::to_string(msg.y.size()) +
                     " y, must be as many");
  }
  std::vector<Eigen::Vector2d> polygon;
  for (std::size_t i = 0; i < msg.x.size(); ++i) {
    if (!std::isfinite(msg.x[i] + msg.y[i])) throw InputError("outline point " + std::to_string(i) + " is not finite");
    polygon.emplace_back(msg.x[i], msg.y[i]);
  }
  return polygon;
}

geometry_msgs::Point32 toPoint32(const Eigen::Vector3f& p) {
  geometry_msgs::Point32 msg;
  msg.x = p.x();
  msg.y = p.y();
  msg.z = p.z();
  return msg;
}

Eigen::Vector3f fromPoint32(const geometry_msgs::Point32& msg, const char* what, std::size_t index) {
  const Eigen::Vector3f p(msg.x, msg.y, msg.z);
  if (!p.allFinite()) throw InputError(what + ("[" + std::to_string(index)) + "] is not finite");
  return p;
}

core::scan::NoReturns noReturns(const core::ScanInfo& info) {
  if (info.no_return_ends.size() != info.no_return_is_too_near.size()) {
    throw InputError("scan_info: " + std::to_string(info.no_return_ends.size()) + " no_return_ends and " +
                     std::to_string(info.no_return_is_too_near.size()) + " no_return_is_too_near, must be as many");
  }
  for (const auto& [name, value] :
       {std::pair("sensor_range", info.sensor_range), std::pair("sensor_nearest", info.sensor_nearest)}) {
    if (!(value >= 0.0 && std::isfinite(value)))
      throw InputError("scan_info", name, std::to_string(value) + " m", "0 or more");
  }
  core::scan::NoReturns returns;
  returns.range = info.sensor_range;
  returns.nearest = info.sensor_nearest;
  for (std::size_t i = 0; i < info.no_return_ends.size(); ++i) {
    const auto& end = info.no_return_ends[i];
    returns.beams.push_back({fromPoint32(end, "scan_info: no_return_ends", i), info.no_return_is_too_near[i] != 0});
  }
  return returns;
}

}  // namespace

core::ScanInfo toInfo(const core::pipeline::ScanStage& stage, const std_msgs::Header& header) {
  core::ScanInfo msg;
  msg.header = header;
  msg.mean_beam = toVector(stage.mean_beam);
  for (const auto& beam : stage.no_returns.beams) {
    msg.no_return_ends.push_back(toPoint32(beam.far_end));
    msg.no_return_is_too_near.push_back(static_cast<std::uint8_t>(beam.is_too_near));
  }
  msg.sensor_range = stage.no_returns.range;
  msg.sensor_nearest = stage.no_returns.nearest;
  msg.report = toMsg(stage.report, stage.accuracy, stage.notes, header);
  return msg;
}

core::pipeline::ScanStage scanStage(const boost::shared_ptr<const core::scan::ScanCloud>& cloud,
                                    const core::ScanInfo& info) {
  core::pipeline::ScanStage stage;
  stage.cloud = {cloud.get(), [cloud](const core::scan::ScanCloud*) {}};
  stage.no_returns = noReturns(info);
  stage.mean_beam = fromVector(info.mean_beam);
  if (!(std::abs(stage.mean_beam.norm() - 1.0) <= 1e-6)) {
    throw InputError("scan_info: mean_beam has length " + std::to_string(stage.mean_beam.norm()) +
                     ", must be 1 within 1e-6");
  }
  stage.report = stageReport(info.report);
  stage.accuracy = accuracy(info.report);
  stage.notes = info.report.notes;
  return stage;
}

core::FittedScan toMsg(const core::pipeline::FitStage& stage, const std_msgs::Header& header) {
  const core::scan::FittedScan& scan = stage.scan;
  core::FittedScan msg;
  msg.header = header;
  msg.scan_frame = toPose(scan.T_cloud_scan);
  msg.lines = converted<core::FittedLine>(scan.lines, [](const auto& line) { return toLine(line); });
  msg.surface = toMsg(scan.surface);
  msg.outline =
      converted<core::OutlinePolygon>(scan.outline.polygons, [](const auto& polygon) { return toPolygon(polygon); });
  msg.obstacles = converted<geometry_msgs::Point32>(scan.obstacles, [](const auto& p) { return toPoint32(p); });
  msg.report = toMsg(stage.report, stage.accuracy, stage.notes, header);
  msg.samples_in = scan.samples_in;
  msg.samples_used = scan.samples_used;
  msg.pitch = scan.pitch;
  msg.line_sigma = scan.line_sigma;
  msg.surface_rms = scan.surface_rms;
  msg.between_rows_rms = scan.between_rows_rms;
  msg.between_rows_largest = scan.between_rows_largest;
  msg.between_rows_share = scan.between_rows_share;
  return msg;
}

core::pipeline::FitStage fromMsg(const core::FittedScan& msg) {
  core::pipeline::FitStage stage;
  core::scan::FittedScan& scan = stage.scan;
  scan.T_cloud_scan = fromPose(msg.scan_frame, "scan_frame");
  scan.lines = converted<core::scan::FittedLine>(msg.lines, [](const auto& line) { return fromLine(line); });
  scan.surface = fromMsg(msg.surface);
  scan.outline.polygons =
      converted<std::vector<Eigen::Vector2d>>(msg.outline, [](const auto& polygon) { return fromPolygon(polygon); });
  for (std::size_t i = 0; i < msg.obstacles.size(); ++i) {
    scan.obstacles.push_back(fromPoint32(msg.obstacles[i], "fitted_scan: obstacles", i));
  }
  stage.report = stageReport(msg.report);
  stage.accuracy = accuracy(msg.report);
  stage.notes = msg.report.notes;
  scan.dropped = stage.report.dropped;
  scan.samples_in = msg.samples_in;
  scan.samples_used = msg.samples_used;
  scan.pitch = msg.pitch;
  scan.line_sigma = msg.line_sigma;
  scan.surface_rms = msg.surface_rms;
  scan.between_rows_rms = msg.between_rows_rms;
  scan.between_rows_largest = msg.between_rows_largest;
  scan.between_rows_share = msg.between_rows_share;
  return stage;
}

}  // namespace scan_to_path_ros
