// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/conversions.h"

#include <cmath>

#include "converted.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path_ros {
namespace {

using core::InputError;

core::ToolPathWaypoint toWaypoint(const core::toolpath::Waypoint& waypoint) {
  core::ToolPathWaypoint msg;
  msg.pose = toPose(waypoint.pose);
  msg.feed = waypoint.feed;
  msg.process_on = static_cast<std::uint8_t>(waypoint.process_on);
  msg.arc_length = waypoint.arc_length;
  return msg;
}

core::toolpath::Waypoint fromWaypoint(const core::ToolPathWaypoint& msg, const std::string& where) {
  core::toolpath::Waypoint waypoint;
  waypoint.pose = fromPose(msg.pose, where);
  waypoint.feed = msg.feed;
  waypoint.process_on = msg.process_on != 0;
  waypoint.arc_length = msg.arc_length;
  if (!(std::isfinite(msg.feed) && msg.feed >= 0.0)) {
    throw InputError(where + ": feed is " + std::to_string(msg.feed) + " m/s, must be finite and 0 or more");
  }
  return waypoint;
}

core::toolpath::Segment fromSegment(const core::ToolPathSegment& msg) {
  core::toolpath::Segment segment;
  segment.name = msg.name;
  segment.waypoints.reserve(msg.waypoints.size());
  for (std::size_t i = 0; i < msg.waypoints.size(); ++i) {
    segment.waypoints.push_back(fromWaypoint(msg.waypoints[i], msg.name + " waypoint " + std::to_string(i)));
  }
  return segment;
}

void checkSizes(const core::MotionPlan& msg) {
  const std::size_t points = msg.time.size();
  if (msg.segment.size() == points && msg.index.size() == points &&
      msg.positions.size() == points * msg.joint_names.size()) {
    return;
  }
  throw InputError("motion plan: " + std::to_string(points) + " times, " + std::to_string(msg.segment.size()) +
                   " segments, " + std::to_string(msg.index.size()) + " indices and " +
                   std::to_string(msg.positions.size()) + " positions of " + std::to_string(msg.joint_names.size()) +
                   " joints do not fit together");
}

void checkFeeds(const core::MotionPlan& msg) {
  if (msg.feeds.size() != msg.verdicts.size()) {
    throw InputError("motion plan: " + std::to_string(msg.feeds.size()) + " feeds of " +
                     std::to_string(msg.verdicts.size()) + " waypoints, must be as many");
  }
  for (std::size_t i = 0; i < msg.feeds.size(); ++i) {
    if (std::isfinite(msg.feeds[i]) && msg.feeds[i] >= 0.0) continue;
    throw InputError("motion plan: feed " + std::to_string(i) + " is " + std::to_string(msg.feeds[i]) +
                     " m/s, must be finite and 0 or more");
  }
}

std::vector<core::WaypointVerdict> toVerdicts(const std::vector<core::toolpath::WaypointVerdict>& verdicts) {
  return converted<core::WaypointVerdict>(verdicts, [](const auto& verdict) { return toMsg(verdict); });
}

std::vector<core::toolpath::WaypointVerdict> fromVerdicts(const std::vector<core::WaypointVerdict>& msgs) {
  return converted<core::toolpath::WaypointVerdict>(msgs, [](const auto& msg) { return fromMsg(msg); });
}

}  // namespace

core::WaypointVerdict toMsg(const core::toolpath::WaypointVerdict& verdict) {
  core::WaypointVerdict msg;
  msg.segment = verdict.segment;
  msg.index = verdict.index;
  msg.verdict = static_cast<std::uint8_t>(verdict.verdict);
  msg.margin = verdict.margin;
  msg.unit = verdict.unit;
  msg.reason = verdict.reason;
  msg.remedy = verdict.remedy;
  return msg;
}

core::toolpath::WaypointVerdict fromMsg(const core::WaypointVerdict& msg) {
  if (msg.verdict >= core::EnumNames<core::toolpath::Verdict>::names.size()) {
    throw InputError("verdict of segment " + std::to_string(msg.segment) + " waypoint " + std::to_string(msg.index) +
                     " is " + std::to_string(msg.verdict) + ", which is none");
  }
  core::toolpath::WaypointVerdict verdict;
  verdict.segment = msg.segment;
  verdict.index = msg.index;
  verdict.verdict = static_cast<core::toolpath::Verdict>(msg.verdict);
  verdict.margin = msg.margin;
  verdict.unit = msg.unit;
  verdict.reason = msg.reason;
  verdict.remedy = msg.remedy;
  return verdict;
}

core::ToolPath toMsg(const core::toolpath::ToolPath& path, const std_msgs::Header& header) {
  core::ToolPath msg;
  msg.header = header;
  msg.header.frame_id = path.frame;
  msg.process = path.process;
  msg.contact_to_tcp = toPose(path.T_contact_tcp);
  msg.segments.reserve(path.segments.size());
  for (const auto& segment : path.segments) {
    core::ToolPathSegment entry;
    entry.name = segment.name;
    entry.waypoints = converted<core::ToolPathWaypoint>(segment.waypoints, [](const auto& w) { return toWaypoint(w); });
    msg.segments.push_back(std::move(entry));
  }
  return msg;
}

core::toolpath::ToolPath fromMsg(const core::ToolPath& msg) {
  core::toolpath::ToolPath path;
  path.process = msg.process;
  path.frame = msg.header.frame_id;
  path.T_contact_tcp = fromPose(msg.contact_to_tcp, "contact_to_tcp");
  path.segments =
      converted<core::toolpath::Segment>(msg.segments, [](const auto& entry) { return fromSegment(entry); });
  return path;
}

core::PlannedPath toMsg(const core::pipeline::PathStage& stage, const std_msgs::Header& header) {
  core::PlannedPath msg;
  msg.header = header;
  msg.path = toMsg(stage.planned.path, header);
  msg.findings = toVerdicts(stage.planned.findings);
  msg.allowances = stage.planned.allowances;
  msg.report = toMsg(stage.report, stage.accuracy, stage.notes, header);
  return msg;
}

core::pipeline::PathStage fromMsg(const core::PlannedPath& msg) {
  core::pipeline::PathStage stage;
  stage.planned.path = fromMsg(msg.path);
  stage.planned.findings = fromVerdicts(msg.findings);
  if (msg.allowances.size() != msg.path.segments.size()) {
    throw InputError("planned path: " + std::to_string(msg.allowances.size()) + " allowances of " +
                     std::to_string(msg.path.segments.size()) + " segments, must be as many");
  }
  stage.planned.allowances = msg.allowances;
  stage.report = stageReport(msg.report);
  stage.accuracy = accuracy(msg.report);
  stage.notes = msg.report.notes;
  return stage;
}

core::MotionPlan toMsg(const core::pipeline::MotionStage& stage, const std_msgs::Header& header) {
  core::MotionPlan msg;
  msg.header = header;
  const core::motion::Trajectory& trajectory = stage.plan.trajectory;
  msg.joint_names = trajectory.joint_names;
  for (const auto& point : trajectory.points) {
    msg.time.push_back(point.time);
    msg.segment.push_back(point.segment);
    msg.index.push_back(point.index);
    msg.positions.insert(msg.positions.end(), point.q.data(), point.q.data() + point.q.size());
  }
  msg.verdicts = toVerdicts(stage.verdicts);
  msg.feeds = stage.plan.feeds;
  msg.max_chord_error = stage.plan.max_chord_error;
  msg.report = toMsg(stage.report, stage.accuracy, stage.notes, header);
  return msg;
}

core::pipeline::MotionStage fromMsg(const core::MotionPlan& msg) {
  checkSizes(msg);
  checkFeeds(msg);
  core::pipeline::MotionStage stage;
  core::motion::Trajectory& trajectory = stage.plan.trajectory;
  trajectory.joint_names = msg.joint_names;
  const auto joints = static_cast<Eigen::Index>(msg.joint_names.size());
  trajectory.points.resize(msg.time.size());
  for (std::size_t i = 0; i < msg.time.size(); ++i) {
    auto& point = trajectory.points[i];
    point.time = msg.time[i];
    point.segment = msg.segment[i];
    point.index = msg.index[i];
    point.q = Eigen::Map<const Eigen::VectorXd>(msg.positions.data() + i * msg.joint_names.size(), joints);
    if (!std::isfinite(point.time) || !point.q.allFinite()) {
      throw InputError("motion plan: point " + std::to_string(i) + " is not finite");
    }
  }
  stage.verdicts = fromVerdicts(msg.verdicts);
  stage.plan.verdicts = stage.verdicts;
  stage.plan.feeds = msg.feeds;
  stage.plan.max_chord_error = msg.max_chord_error;
  stage.report = stageReport(msg.report);
  stage.accuracy = accuracy(msg.report);
  stage.notes = msg.report.notes;
  return stage;
}

trajectory_msgs::JointTrajectory toJointTrajectory(const core::motion::Trajectory& trajectory,
                                                   const std_msgs::Header& header) {
  trajectory_msgs::JointTrajectory msg;
  msg.header = header;
  msg.joint_names = trajectory.joint_names;
  msg.points.reserve(trajectory.points.size());
  for (const auto& point : trajectory.points) {
    trajectory_msgs::JointTrajectoryPoint entry;
    entry.positions.assign(point.q.data(), point.q.data() + point.q.size());
    entry.time_from_start = ros::Duration(point.time);
    msg.points.push_back(std::move(entry));
  }
  return msg;
}

}  // namespace scan_to_path_ros
