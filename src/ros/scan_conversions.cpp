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

}  // namespace

core::ScanInfo toInfo(const core::pipeline::ScanStage& stage, const std_msgs::Header& header) {
  core::ScanInfo msg;
  msg.header = header;
  msg.mean_beam = toVector(stage.mean_beam);
  msg.report = toMsg(stage.report, stage.accuracy, stage.notes, header);
  return msg;
}

core::pipeline::ScanStage scanStage(const core::scan::ScanCloud& cloud, const core::ScanInfo& info) {
  core::pipeline::ScanStage stage;
  stage.cloud = cloud;
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
  msg.report = toMsg(stage.report, stage.accuracy, stage.notes, header);
  msg.samples_in = scan.samples_in;
  msg.samples_used = scan.samples_used;
  msg.pitch = scan.pitch;
  msg.line_sigma = scan.line_sigma;
  msg.surface_rms = scan.surface_rms;
  msg.between_rows_rms = scan.between_rows_rms;
  msg.between_rows_largest = scan.between_rows_largest;
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
  return stage;
}

}  // namespace scan_to_path_ros
