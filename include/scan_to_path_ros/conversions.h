// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>
#include <scan_to_path/FittedScan.h>
#include <scan_to_path/MotionPlan.h>
#include <scan_to_path/NurbsCurve.h>
#include <scan_to_path/NurbsSurface.h>
#include <scan_to_path/PlannedPath.h>
#include <scan_to_path/ScanInfo.h>
#include <scan_to_path/StageReport.h>
#include <scan_to_path/ToolPath.h>
#include <scan_to_path/WaypointVerdict.h>
#include <trajectory_msgs/JointTrajectory.h>

#include "scan_to_path/pipeline/stages.h"

/// The stages' values as messages and back. A value that went through a message is the same to the last bit: that is
/// what lets a job spread over nodelets write the same files as the command line. Rotations must be snapped (as the
/// stages make them); everything else is copied. fromMsg throws InputError for a message that no stage can have sent:
/// numbers that are not finite, sizes that do not fit together, names of verdicts that do not exist.
namespace scan_to_path_ros {

namespace core = scan_to_path;

geometry_msgs::Point toPoint(const core::geometry::Vector3& p);
geometry_msgs::Vector3 toVector(const core::geometry::Vector3& v);
core::geometry::Vector3 fromPoint(const geometry_msgs::Point& p);
core::geometry::Vector3 fromVector(const geometry_msgs::Vector3& v);

geometry_msgs::Pose toPose(const core::geometry::Frame& T);
/// The snapped frame of a pose. Throws InputError, naming `what`, unless finite and of unit length within 1e-6.
core::geometry::Frame fromPose(const geometry_msgs::Pose& pose, const std::string& what);

/// A stage's figures in one message; `header` is the job's.
core::StageReport toMsg(const core::pipeline::StageReport& report,
                        const std::vector<core::pipeline::Accuracy>& accuracy, const std::vector<std::string>& notes,
                        const std_msgs::Header& header);
core::pipeline::StageReport stageReport(const core::StageReport& msg);
std::vector<core::pipeline::Accuracy> accuracy(const core::StageReport& msg);

core::NurbsCurve toMsg(const core::nurbs::Curve& curve);
core::nurbs::Curve fromMsg(const core::NurbsCurve& msg);
core::NurbsSurface toMsg(const core::nurbs::Surface& surface);
core::nurbs::Surface fromMsg(const core::NurbsSurface& msg);

core::WaypointVerdict toMsg(const core::toolpath::WaypointVerdict& verdict);
core::toolpath::WaypointVerdict fromMsg(const core::WaypointVerdict& msg);

core::ToolPath toMsg(const core::toolpath::ToolPath& path, const std_msgs::Header& header);
core::toolpath::ToolPath fromMsg(const core::ToolPath& msg);

/// What a scan says beside its cloud; and the two together as the fit takes them.
core::ScanInfo toInfo(const core::pipeline::ScanStage& stage, const std_msgs::Header& header);
core::pipeline::ScanStage scanStage(const boost::shared_ptr<const core::scan::ScanCloud>& cloud,
                                    const core::ScanInfo& info);

core::FittedScan toMsg(const core::pipeline::FitStage& stage, const std_msgs::Header& header);
core::pipeline::FitStage fromMsg(const core::FittedScan& msg);

core::PlannedPath toMsg(const core::pipeline::PathStage& stage, const std_msgs::Header& header);
core::pipeline::PathStage fromMsg(const core::PlannedPath& msg);

core::MotionPlan toMsg(const core::pipeline::MotionStage& stage, const std_msgs::Header& header);
core::pipeline::MotionStage fromMsg(const core::MotionPlan& msg);

/// The trajectory as controllers and rviz take it; times are rounded to the nanosecond.
trajectory_msgs::JointTrajectory toJointTrajectory(const core::motion::Trajectory& trajectory,
                                                   const std_msgs::Header& header);

}  // namespace scan_to_path_ros
