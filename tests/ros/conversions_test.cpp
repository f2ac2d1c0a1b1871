// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/conversions.h"

#include <gmock/gmock.h>
#include <ros/serialization.h>
#include <boost/make_shared.hpp>

#include <cstring>
#include <limits>

#include "pipeline/small_scan.h"
#include "scan_to_path/pipeline/path_stage.h"
#include "support/expect_input_error.h"

namespace scan_to_path_ros {
namespace {

namespace pipeline = core::pipeline;
using core::test::expectInputError;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The message after a way over the wire.
template <class Message>
Message sent(const Message& message) {
  const ros::SerializedMessage wire = ros::serialization::serializeMessage(message);
  Message received;
  ros::serialization::IStream stream(wire.message_start, static_cast<std::uint32_t>(wire.num_bytes - 4));
  ros::serialization::deserialize(stream, received);
  return received;
}

/// The same bits, signs of zeros included.
template <class A, class B>
bool sameBits(const A& a, const B& b) {
  const auto size = static_cast<std::size_t>(a.size());
  return size == static_cast<std::size_t>(b.size()) && std::memcmp(a.data(), b.data(), sizeof(double) * size) == 0;
}

void expectSame(const std::vector<core::geometry::Vector3>& a, const std::vector<core::geometry::Vector3>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_TRUE(sameBits(a[i], b[i])) << i;
}

void expectSame(const pipeline::StageReport& a, const pipeline::StageReport& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.in, b.in);
  EXPECT_EQ(a.out, b.out);
  ASSERT_EQ(a.dropped.size(), b.dropped.size());
  for (std::size_t i = 0; i < a.dropped.size(); ++i) {
    EXPECT_EQ(a.dropped[i].reason, b.dropped[i].reason);
    EXPECT_EQ(a.dropped[i].count, b.dropped[i].count);
  }
}

void expectSame(const std::vector<pipeline::Accuracy>& a, const std::vector<pipeline::Accuracy>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].value, b[i].value) << a[i].name;
    EXPECT_EQ(a[i].unit, b[i].unit);
    EXPECT_EQ(a[i].limit, b[i].limit) << a[i].name;
  }
}

void expectSame(const std::vector<core::toolpath::WaypointVerdict>& a,
                const std::vector<core::toolpath::WaypointVerdict>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].segment, b[i].segment);
    EXPECT_EQ(a[i].index, b[i].index);
    EXPECT_EQ(a[i].verdict, b[i].verdict);
    EXPECT_EQ(a[i].margin, b[i].margin);
    EXPECT_EQ(a[i].unit + a[i].reason + a[i].remedy, b[i].unit + b[i].reason + b[i].remedy);
  }
}

/// Real values of every stage: the small part, scanned, fitted, planned and driven.
struct Stages {
  pipeline::JobOptions options;
  pipeline::Cell cell = pipeline::makeCell(options.cell, pipeline::source_package);
  pipeline::ScanStage scan =
      pipeline::scanFromSamples(pipeline::smallScan(), cell, options.scan, options.report, 1, {});
  pipeline::FitStage fit = pipeline::fitStage(scan, options.scan, options.fit, options.report, 1, {});
  pipeline::PathStage path = plan(fit);
  pipeline::MotionStage motion = pipeline::motionStage(path, cell, options, {});

  pipeline::PathStage plan(const pipeline::FitStage& from) const {
    return pipeline::pathStage(*pipeline::makePlanner("cutting", options), from.scan, "base_link", options, {});
  }
};

const Stages& stages() {
  static const Stages all;
  return all;
}

std_msgs::Header header() {
  std_msgs::Header header;
  header.stamp = ros::Time(12, 345678000);
  header.frame_id = "base_link";
  return header;
}

core::toolpath::WaypointVerdict anyVerdict() {
  core::toolpath::WaypointVerdict verdict;
  verdict.segment = 3;
  verdict.index = 17;
  verdict.verdict = core::toolpath::Verdict::jump;
  verdict.margin = -0.125;
  verdict.unit = "rad";
  verdict.reason = "joint_4 turns over";
  verdict.remedy = "tilt the tool";
  return verdict;
}

TEST(Conversions, ScanKeepsItsCloudBeamAndReport) {
  pipeline::ScanStage scan = stages().scan;
  scan.notes.push_back("a note");
  scan.no_returns = {{{Eigen::Vector3f(0.1F, -0.2F, 0.3F), false}, {Eigen::Vector3f(0.4F, 0.5F, 0.6F), true}}, 0.05};
  const auto info = sent(toInfo(scan, header()));
  EXPECT_EQ(info.header.stamp, header().stamp);
  const auto cloud = boost::make_shared<core::scan::ScanCloud>(*scan.cloud);
  const auto back = scanStage(cloud, info);
  EXPECT_EQ(back.cloud.get(), cloud.get());  // no copy
  EXPECT_TRUE(sameBits(back.mean_beam, scan.mean_beam));
  EXPECT_EQ(back.no_returns.range, scan.no_returns.range);
  ASSERT_EQ(back.no_returns.beams.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.no_returns.beams[i].far_end, scan.no_returns.beams[i].far_end);
    EXPECT_EQ(back.no_returns.beams[i].is_too_near, scan.no_returns.beams[i].is_too_near);
  }
  EXPECT_EQ(back.notes, scan.notes);
  expectSame(back.report, scan.report);
  expectSame(back.accuracy, scan.accuracy);
}

TEST(Conversions, FittedScanIsTheSameToTheLastBit) {
  pipeline::FitStage fit = stages().fit;
  fit.notes.push_back("a note");
  const auto back = fromMsg(sent(toMsg(fit, header())));
  EXPECT_TRUE(sameBits(back.scan.T_cloud_scan.matrix(), fit.scan.T_cloud_scan.matrix()));
  ASSERT_EQ(back.scan.lines.size(), fit.scan.lines.size());
  ASSERT_GT(fit.scan.lines.size(), 5U);
  for (std::size_t i = 0; i < fit.scan.lines.size(); ++i) {
    const auto& a = back.scan.lines[i];
    const auto& b = fit.scan.lines[i];
    EXPECT_EQ(a.row, b.row);
    EXPECT_EQ(a.forward, b.forward);
    EXPECT_EQ(a.curve.degree, b.curve.degree);
    EXPECT_TRUE(sameBits(a.curve.knots, b.curve.knots));
    expectSame(a.curve.control_points, b.curve.control_points);
    EXPECT_EQ(a.curve.weights, b.curve.weights);
    EXPECT_EQ(a.begin, b.begin);
    EXPECT_EQ(a.end, b.end);
    EXPECT_EQ(a.begins_at_edge, b.begins_at_edge);
    EXPECT_EQ(a.ends_at_edge, b.ends_at_edge);
    EXPECT_EQ(a.samples, b.samples);
    EXPECT_EQ(a.residual_rms, b.residual_rms);
    EXPECT_EQ(a.sigma, b.sigma);
  }
  EXPECT_TRUE(sameBits(back.scan.surface.knots_u, fit.scan.surface.knots_u));
  EXPECT_TRUE(sameBits(back.scan.surface.knots_v, fit.scan.surface.knots_v));
  expectSame(back.scan.surface.control_points, fit.scan.surface.control_points);
  ASSERT_EQ(back.scan.outline.polygons.size(), fit.scan.outline.polygons.size());
  for (std::size_t i = 0; i < fit.scan.outline.polygons.size(); ++i) {
    EXPECT_EQ(back.scan.outline.polygons[i], fit.scan.outline.polygons[i]);
  }
  EXPECT_EQ(back.scan.samples_in, fit.scan.samples_in);
  EXPECT_EQ(back.scan.samples_used, fit.scan.samples_used);
  EXPECT_EQ(back.scan.pitch, fit.scan.pitch);
  EXPECT_EQ(back.scan.line_sigma, fit.scan.line_sigma);
  EXPECT_EQ(back.scan.surface_rms, fit.scan.surface_rms);
  EXPECT_EQ(back.scan.between_rows_rms, fit.scan.between_rows_rms);
  EXPECT_EQ(back.scan.between_rows_largest, fit.scan.between_rows_largest);
  EXPECT_EQ(back.scan.between_rows_share, fit.scan.between_rows_share);
  EXPECT_EQ(back.scan.dropped.size(), fit.scan.dropped.size());
  EXPECT_EQ(back.notes, fit.notes);
  expectSame(back.report, fit.report);
  expectSame(back.accuracy, fit.accuracy);
}

TEST(Conversions, PlannedPathIsTheSameToTheLastBit) {
  pipeline::PathStage path = stages().path;
  path.planned.findings.push_back(anyVerdict());
  const auto back = fromMsg(sent(toMsg(path, header())));
  EXPECT_EQ(back.planned.path.process, path.planned.path.process);
  EXPECT_EQ(back.planned.path.frame, path.planned.path.frame);
  EXPECT_TRUE(sameBits(back.planned.path.T_contact_tcp.matrix(), path.planned.path.T_contact_tcp.matrix()));
  ASSERT_EQ(back.planned.path.segments.size(), path.planned.path.segments.size());
  for (std::size_t k = 0; k < path.planned.path.segments.size(); ++k) {
    const auto& a = back.planned.path.segments[k];
    const auto& b = path.planned.path.segments[k];
    EXPECT_EQ(a.name, b.name);
    ASSERT_EQ(a.waypoints.size(), b.waypoints.size());
    for (std::size_t i = 0; i < a.waypoints.size(); ++i) {
      ASSERT_TRUE(sameBits(a.waypoints[i].pose.matrix(), b.waypoints[i].pose.matrix())) << b.name << " " << i;
      ASSERT_EQ(a.waypoints[i].feed, b.waypoints[i].feed);
      ASSERT_EQ(a.waypoints[i].process_on, b.waypoints[i].process_on);
      ASSERT_EQ(a.waypoints[i].arc_length, b.waypoints[i].arc_length);
    }
  }
  EXPECT_EQ(back.planned.allowances, path.planned.allowances);
  expectSame(back.planned.findings, path.planned.findings);
  expectSame(back.report, path.report);
  expectSame(back.accuracy, path.accuracy);
}

TEST(Conversions, MotionPlanIsTheSameToTheLastBit) {
  pipeline::MotionStage motion = stages().motion;
  motion.verdicts.front() = anyVerdict();
  ASSERT_EQ(motion.plan.feeds.size(), motion.verdicts.size());
  motion.plan.feeds[7] *= 1.0 / 3.0;  // as where a joint would be too fast
  const auto back = fromMsg(sent(toMsg(motion, header())));
  EXPECT_EQ(back.plan.trajectory.joint_names, motion.plan.trajectory.joint_names);
  ASSERT_EQ(back.plan.trajectory.points.size(), motion.plan.trajectory.points.size());
  for (std::size_t i = 0; i < motion.plan.trajectory.points.size(); ++i) {
    const auto& a = back.plan.trajectory.points[i];
    const auto& b = motion.plan.trajectory.points[i];
    ASSERT_EQ(a.time, b.time);
    ASSERT_EQ(a.segment, b.segment);
    ASSERT_EQ(a.index, b.index);
    ASSERT_TRUE(sameBits(a.q, b.q)) << i;
  }
  expectSame(back.verdicts, motion.verdicts);
  EXPECT_EQ(back.plan.feeds, motion.plan.feeds);
  EXPECT_EQ(back.plan.max_chord_error, motion.plan.max_chord_error);
  expectSame(back.report, motion.report);
  expectSame(back.accuracy, motion.accuracy);
}

TEST(Conversions, AFrameThatIsNotSnappedWouldBeSeen) {
  // The mutation: a rotation that is not as the stages make them comes back with other bits.
  core::geometry::Frame T = core::geometry::Frame::Identity();
  T.linear() =
      Eigen::AngleAxisd(0.1234567890123456789, core::geometry::Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  EXPECT_FALSE(sameBits(fromPose(toPose(T), "frame").matrix(), T.matrix()));
  T = core::geometry::snapped(T);
  EXPECT_TRUE(sameBits(fromPose(toPose(T), "frame").matrix(), T.matrix()));
}

TEST(Conversions, EmptyValuesStayEmpty) {
  const auto fit = fromMsg(sent(toMsg(pipeline::FitStage(), header())));
  EXPECT_TRUE(fit.scan.lines.empty());
  EXPECT_TRUE(fit.scan.surface.control_points.empty());
  const auto path = fromMsg(sent(toMsg(pipeline::PathStage(), header())));
  EXPECT_TRUE(path.planned.path.segments.empty());
  const auto motion = fromMsg(sent(toMsg(pipeline::MotionStage(), header())));
  EXPECT_TRUE(motion.plan.trajectory.points.empty());
}

TEST(Conversions, RefusesPosesThatAreNone) {
  geometry_msgs::Pose pose = toPose(core::geometry::Frame::Identity());
  pose.position.y = nan;
  expectInputError([&] { fromPose(pose, "here"); }, "here: position is not finite");
  pose.position.y = infinity;
  expectInputError([&] { fromPose(pose, "here"); }, "here: position is not finite");
  expectInputError([] { fromPose(geometry_msgs::Pose(), "here"); }, "the quaternion's length is 0");
  pose = toPose(core::geometry::Frame::Identity());
  pose.orientation.x = nan;
  expectInputError([&] { fromPose(pose, "here"); }, "the quaternion's length is nan");
}

TEST(Conversions, RefusesFitsThatDoNotFitTogether) {
  const auto good = toMsg(stages().fit, header());
  auto bad = good;
  bad.lines[1].curve.knots.pop_back();
  EXPECT_THROW(fromMsg(bad), core::InputError);
  bad = good;
  bad.lines[1].curve.control_points[2].z = nan;
  EXPECT_THROW(fromMsg(bad), core::InputError);
  bad = good;
  bad.lines[1].end = nan;
  expectInputError([&] { fromMsg(bad); }, "begin");
  bad = good;
  bad.surface.control_points.pop_back();
  EXPECT_THROW(fromMsg(bad), core::InputError);
  bad = good;
  bad.outline.front().x.pop_back();
  expectInputError([&] { fromMsg(bad); }, "outline: ");
  bad = good;
  bad.outline.front().y.front() = infinity;
  expectInputError([&] { fromMsg(bad); }, "outline point 0 is not finite");
  core::ScanInfo info = toInfo(stages().scan, header());
  info.mean_beam.x = nan;
  const auto cloud = boost::make_shared<core::scan::ScanCloud>();
  expectInputError([&] { scanStage(cloud, info); }, "mean_beam has length nan");
  info = toInfo(stages().scan, header());
  info.no_return_is_too_near.push_back(1);
  expectInputError([&] { scanStage(cloud, info); }, "no_return_is_too_near, must be as many");
  info.no_return_ends.resize(info.no_return_is_too_near.size());
  info.no_return_ends.back().y = static_cast<float>(nan);
  expectInputError([&] { scanStage(cloud, info); }, "is not finite");
}

TEST(Conversions, RefusesPathsAndMotionsThatDoNotFitTogether) {
  auto path = toMsg(stages().path, header());
  path.allowances.pop_back();
  expectInputError([&] { fromMsg(path); }, "allowances");
  path = toMsg(stages().path, header());
  path.path.segments[0].waypoints[0].feed = nan;
  expectInputError([&] { fromMsg(path); }, "waypoint 0: feed is nan");
  path.path.segments[0].waypoints[0].feed = -0.1;
  expectInputError([&] { fromMsg(path); }, "waypoint 0: feed is -0.1");
  auto motion = toMsg(stages().motion, header());
  motion.positions.pop_back();
  expectInputError([&] { fromMsg(motion); }, "do not fit together");
  motion = toMsg(stages().motion, header());
  motion.positions[7] = nan;
  expectInputError([&] { fromMsg(motion); }, "point 1 is not finite");
  motion = toMsg(stages().motion, header());
  motion.feeds[3] = nan;
  expectInputError([&] { fromMsg(motion); }, "feed 3 is nan m/s");
  motion.feeds[3] = -0.1;
  expectInputError([&] { fromMsg(motion); }, "feed 3 is -0.1");
  motion.feeds.pop_back();
  expectInputError([&] { fromMsg(motion); }, "must be as many");
  core::WaypointVerdict verdict = toMsg(anyVerdict());
  verdict.verdict = 8;
  expectInputError([&] { fromMsg(verdict); }, "is 8, which is none");
}

TEST(Conversions, JointTrajectoryHasTheTimesToTheNanosecond) {
  const auto& trajectory = stages().motion.plan.trajectory;
  const auto msg = toJointTrajectory(trajectory, header());
  EXPECT_EQ(msg.joint_names, trajectory.joint_names);
  ASSERT_EQ(msg.points.size(), trajectory.points.size());
  for (std::size_t i = 0; i < msg.points.size(); ++i) {
    EXPECT_NEAR(msg.points[i].time_from_start.toSec(), trajectory.points[i].time,
                1e-9);  // half a nanosecond, and the double's
    ASSERT_TRUE(sameBits(msg.points[i].positions, trajectory.points[i].q)) << i;
  }
}

}  // namespace
}  // namespace scan_to_path_ros
