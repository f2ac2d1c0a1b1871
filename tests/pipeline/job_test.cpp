// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/job.h"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "job_fixture.h"
#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/motion/trajectory.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::pipeline {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST_F(JobTest, WritesEveryFileAndSucceeds) {
  const auto job = request("whole");
  const JobResult result = runJob(job, {}, {});
  EXPECT_EQ(result.exit, 0) << ::testing::PrintToString(result.summary);
  EXPECT_EQ(files(job), (std::set<std::string>{"path.csv", "trajectory.csv", "pulses.csv", "program.mod", "program.pgf",
                                               "report.json", "timing.json"}));
  EXPECT_FALSE(fs::exists(job.out.string() + ".part"));
  const auto path = toolpath::parseToolPath(file(job, "path.csv"), "path.csv");
  const auto trajectory = motion::parseTrajectory(file(job, "trajectory.csv"), "trajectory.csv");
  EXPECT_GE(trajectory.points.size(), toolpath::waypointCount(path));
  const auto report = nlohmann::json::parse(file(job, "report.json"));
  EXPECT_EQ(report["summary"]["ok"], toolpath::waypointCount(path));
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_EQ(report["input"]["kind"], "samples");
}

TEST_F(JobTest, AfterThePathEveryWaypointHasAVerdict) {
  auto job = request("verdicts");
  job.input = *directory_ / "verdicts.csv";
  job.stop_after = Stage::path;
  std::ofstream(job.input) << scan::formatSampleLog(smallScan(Groove()));
  const JobResult result = runJob(job, grooveOptions(), {});
  EXPECT_EQ(result.exit, 1);
  const auto report = nlohmann::json::parse(file(job, "report.json"));
  const std::size_t waypoints = toolpath::waypointCount(toolpath::parseToolPath(file(job, "path.csv"), "path.csv"));
  const std::size_t gouges = report["accuracy"]["path_gouges"]["value"];
  ASSERT_GT(gouges, 0U);
  EXPECT_EQ(report["waypoints"].size(), waypoints);
  EXPECT_EQ(report["summary"]["failed"], gouges);
  EXPECT_EQ(report["summary"]["ok"], waypoints - gouges);
  EXPECT_TRUE(report["waypoints"][0]["margin"].is_null());
  const std::string share = std::to_string(gouges) + " of " + std::to_string(waypoints) + " waypoints: gouge";
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr(share)));
}

TEST_F(JobTest, StopsAfterTheStageAskedFor) {
  const std::map<Stage, std::set<std::string>> expected = {
      {Stage::scan, {"report.json", "timing.json"}},
      {Stage::fit, {"report.json", "timing.json"}},
      {Stage::path, {"path.csv", "report.json", "timing.json"}},
      {Stage::motion, {"path.csv", "report.json", "timing.json", "trajectory.csv"}}};
  for (const auto& [stage, names] : expected) {
    auto job = request(std::string("stop_") + enumName(stage));
    job.stop_after = stage;
    EXPECT_EQ(runJob(job, {}, {}).exit, 0);
    EXPECT_EQ(files(job), names) << enumName(stage);
  }
}

TEST_F(JobTest, ASurfaceTooFarOffFailsAndNamesTheRemedy) {
  JobOptions options;
  options.report.max_surface_residual = 1e-6;  // [m] the samples' noise alone is twice that
  auto job = request("far_off");
  job.stop_after = Stage::path;
  EXPECT_EQ(runJob(job, options, {}).exit, 1);
  const auto report = nlohmann::json::parse(file(job, "report.json"));
  EXPECT_EQ(report["accuracy"]["path_surface_residual_rms"]["pass"], false);
  EXPECT_THAT(report["notes"].dump(), HasSubstr("path.row_source=scan_lines"));
  options.path.row_source = process::RowSource::scan_lines;  // what the note says helps
  EXPECT_EQ(runJob(job, options, {}).exit, 0);
}

TEST_F(JobTest, SameBytesTwiceAndWithTwoThreads) {
  const auto first = request("first");
  auto second = request("second");
  second.threads = 2;
  runJob(first, {}, {});
  runJob(second, {}, {});
  for (const auto& name : files(first)) {
    if (name != "timing.json") {
      EXPECT_TRUE(file(first, name) == file(second, name)) << name;
    }
  }
}

TEST_F(JobTest, ReferenceChangesNothingButTheReport) {
  const auto blind = request("blind");
  auto measured = request("measured");
  measured.reference = std::make_shared<geometry::PosedSurface>(
      std::make_shared<geometry::Saddle>(smallPart()),
      geometry::makeFrame(CellOptions().workpiece.xyz, CellOptions().workpiece.rpy));
  runJob(blind, {}, {});
  runJob(measured, {}, {});
  for (const auto& name : files(blind)) {
    if (name != "timing.json" && name != "report.json") {
      EXPECT_TRUE(file(blind, name) == file(measured, name)) << name;
    }
  }
  const auto report = nlohmann::json::parse(file(measured, "report.json"));
  // Noise of 2 um over 1,200 samples and a handful of control points a row: far below 1 um.
  EXPECT_LT(report["accuracy"]["reference_path_rms"]["value"].get<double>(), 1e-6);
  EXPECT_FALSE(nlohmann::json::parse(file(blind, "report.json"))["accuracy"].contains("reference_path_rms"));
}

TEST_F(JobTest, ADirectoryThatHoldsSomethingElseIsNotReplaced) {
  auto job = request("mixed");
  fs::create_directories(job.out);
  std::ofstream(job.out / "thesis.txt") << "three years";
  job.stop_after = Stage::scan;
  EXPECT_THAT(errorOf(job), HasSubstr("holds thesis.txt"));
  EXPECT_EQ(file(job, "thesis.txt"), "three years");
}

TEST_F(JobTest, SamplesWithoutJointReadingsCountAsLost) {
  auto log = smallScan();
  const std::size_t joints = log.joint_names.size();
  const std::size_t begin = log.joint_time.size() / 3;
  const std::size_t end = begin + log.joint_time.size() / 6;
  const auto at = [](auto& values, std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
  log.joint_time.erase(at(log.joint_time, begin), at(log.joint_time, end));
  log.counts.erase(at(log.counts, begin * joints), at(log.counts, end * joints));
  auto job = request("holes");
  job.input = *directory_ / "holes.csv";
  job.stop_after = Stage::fit;
  std::ofstream(job.input) << scan::formatSampleLog(log);
  const JobResult result = runJob(job, {}, {});
  EXPECT_EQ(result.exit, 1);
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("dropped_share")));
}

TEST_F(JobTest, WhatWasNotSeenInsideThePartIsNoted) {
  const auto plate = [](double x_min, double x_max, double y_min, double y_max) {
    return std::make_shared<geometry::FlatPart>(geometry::Rectangle{x_min, x_max, y_min, y_max});
  };
  const geometry::Scene part({plate(-0.03, -0.01, -0.03, 0.03), plate(0.01, 0.03, -0.03, 0.03),
                              plate(-0.01, 0.01, -0.03, -0.01), plate(-0.01, 0.01, 0.01, 0.03)});
  auto job = request("pocket");
  job.input = *directory_ / "pocket.csv";
  job.stop_after = Stage::fit;
  std::ofstream(job.input) << scan::formatSampleLog(smallScan(part));
  EXPECT_THAT(runJob(job, {}, {}).summary, ::testing::Contains(HasSubstr("sweep the part a second time")));
  job.input = *directory_ / "samples.csv";
  EXPECT_THAT(runJob(job, {}, {}).summary, ::testing::Not(::testing::Contains(HasSubstr("second time"))));
}

TEST_F(JobTest, ABrokenToleranceFailsTheJobByName) {
  JobOptions options;
  options.report.max_line_residual = 1e-7;
  auto job = request("tolerance");
  job.stop_after = Stage::fit;
  const JobResult result = runJob(job, options, {});
  EXPECT_EQ(result.exit, 1);
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("line_residual_rms")));
}

TEST_F(JobTest, AnUncorrectedClockOffsetFailsAndACorrectedOnePasses) {
  auto log = smallScan();
  for (double& time : log.sensor_time) time -= 1e-3;
  auto job = request("clocks");
  job.input = *directory_ / "clocks.csv";
  job.stop_after = Stage::fit;
  std::ofstream(job.input) << scan::formatSampleLog(log);
  const JobResult result = runJob(job, {}, {});
  EXPECT_EQ(result.exit, 1);
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("off the encoders' by 1.0")));
  JobOptions options;
  options.scan.correct_clock_offset = true;
  EXPECT_EQ(runJob(job, options, {}).exit, 0);
  options.scan.correct_clock_offset = false;
  options.scan.placement.clock_offset = 1e-3;
  EXPECT_EQ(runJob(job, options, {}).exit, 0);
}

TEST_F(JobTest, BadInputLeavesAnOlderResultAlone) {
  auto job = request("older");
  job.stop_after = Stage::path;
  runJob(job, {}, {});
  const std::string before = file(job, "path.csv");
  job.input = *directory_ / "none.csv";
  EXPECT_THAT(errorOf(job), HasSubstr("cannot read"));
  EXPECT_EQ(file(job, "path.csv"), before);
  EXPECT_FALSE(fs::exists(job.out.string() + ".part"));
}

TEST_F(JobTest, CancelInAnyStageWritesNothing) {
  for (const char* stage : {"read", "lines", "path", "motion", "write"}) {
    std::atomic<bool> cancelled{false};
    const Progress progress(
        [&](const std::string& name, double) {
          if (name == stage) cancelled = true;
        },
        &cancelled);
    const auto job = request(std::string("cancelled_") + stage);
    EXPECT_THROW(runJob(job, {}, progress), Interrupted) << stage;
    EXPECT_TRUE(files(job).empty()) << stage;
    EXPECT_FALSE(fs::exists(job.out.string() + ".part")) << stage;
  }
}

TEST_F(JobTest, RefusesWhatItCannotPlanFrom) {
  auto job = request("refused");
  std::ofstream(*directory_ / "part.stl") << "solid a\nendsolid a\n";
  job.input = *directory_ / "part.stl";
  EXPECT_THAT(errorOf(job), HasSubstr("emulate --workpiece part.stl"));
  job = request("refused");
  job.process = "grinding";
  EXPECT_THAT(errorOf(job), HasSubstr("known: cutting"));
  JobOptions options;
  options.path.ball_radius = -1.0;
  EXPECT_THAT(errorOf(request("refused"), options), HasSubstr("path.ball_radius is -1 m, must be in"));
}

TEST_F(JobTest, ReportMutationIsSeen) {
  // The twin of the checks above: a wrong reference must show in the figure.
  auto job = request("mutated");
  job.stop_after = Stage::path;
  const auto& mount = CellOptions().workpiece;
  job.reference =
      std::make_shared<geometry::PosedSurface>(std::make_shared<geometry::Saddle>(smallPart()),
                                               geometry::makeFrame(mount.xyz + Vector3(0.0, 0.0, 1e-5), mount.rpy));
  runJob(job, {}, {});
  const auto report = nlohmann::json::parse(file(job, "report.json"));
  EXPECT_GT(report["accuracy"]["reference_path_rms"]["value"].get<double>(), 9e-6);
}

}  // namespace
}  // namespace scan_to_path::pipeline
