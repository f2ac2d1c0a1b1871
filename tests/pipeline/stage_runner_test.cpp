// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/stage_runner.h"

#include <gmock/gmock.h>

#include <fstream>
#include <vector>

#include "scan_to_path/common/text.h"
#include "scan_to_path/scan/cloud_io.h"
#include "scan_to_path/scan/sample_log.h"
#include "small_scan.h"

namespace scan_to_path::pipeline {
namespace {

namespace fs = std::filesystem;

/// Runs the stages here and notes which were asked for; its scan is another's.
class NotingRunner : public StageRunner {
public:
  NotingRunner(const JobRequest& request, const JobOptions& options, const Cell& cell, ScanStage scan)
      : StageRunner(request, options, cell), scan_(std::move(scan)) {}
  ScanStage scan(const Progress&) override {
    asked.push_back("scan");
    return scan_;
  }
  JobInput input(const ScanStage&) override {
    return {"elsewhere", std::string(64, '0'), InputKind::cloud, Units::m, program::ProgramFile{"scan.pcd", "kept"}};
  }
  FitStage fit(const ScanStage& scanned, const Progress& progress) override {
    asked.push_back("fit");
    return StageRunner::fit(scanned, progress);
  }
  PathStage path(const process::Planner& planner, const FitStage& fitted, const Progress& progress) override {
    asked.push_back("path");
    return StageRunner::path(planner, fitted, progress);
  }
  MotionStage motion(const PathStage& driven, const Progress& progress) override {
    asked.push_back("motion");
    return StageRunner::motion(driven, progress);
  }
  bool accepts(const Progress&) override {
    asked.push_back("accepts");
    return wanted;
  }
  std::vector<std::string> asked;
  bool wanted = true;

private:
  ScanStage scan_;
};

class StageRunnerTest : public ::testing::Test {
protected:
  void SetUp() override {
    directory_ = freshDirectory("stage_runner");
    std::ofstream(directory_ / "samples.csv") << scan::formatSampleLog(smallScan());
  }
  void TearDown() override { fs::remove_all(directory_); }

  JobRequest request(const std::string& input, const std::string& out) const {
    JobRequest request;
    request.input = directory_ / input;
    request.out = directory_ / out;
    request.package_path = source_package;
    return request;
  }
  ScanStage scanOf(const JobRequest& request) const {
    FileRunner runner(request, options_, cell_);
    runner.read({});
    return runner.scan({});
  }

  fs::path directory_;
  JobOptions options_;
  Cell cell_ = makeCell(options_.cell, source_package);
};

TEST_F(StageRunnerTest, WhoeverRunsTheStagesTheFilesAreTheSame) {
  const JobRequest local = request("samples.csv", "local");
  runJob(local, options_, {});
  const JobRequest remote = request("", "remote");
  NotingRunner runner(remote, options_, cell_, scanOf(local));
  runJob(remote, options_, cell_, runner, {});
  EXPECT_EQ(runner.asked, (std::vector<std::string>{"scan", "fit", "path", "motion", "accepts"}));
  for (const char* name : {"path.csv", "trajectory.csv", "pulses.csv"}) {
    EXPECT_EQ(readFile(remote.out / name), readFile(local.out / name)) << name;
  }
  EXPECT_EQ(readFile(remote.out / "scan.pcd"), "kept");
  EXPECT_THAT(readFile(remote.out / "report.json"), ::testing::HasSubstr("\"elsewhere\""));
}

TEST_F(StageRunnerTest, APartialPathIsReplannedHereWhoeverRunsTheStages) {
  std::ofstream(directory_ / "groove.csv") << scan::formatSampleLog(smallScan(Groove()));
  options_ = grooveOptions();
  for (const double dry_offset : {0.0, 0.05}) {
    options_.program.dry_offset = dry_offset;
    JobRequest local = request("groove.csv", "local");
    JobRequest remote = request("", "remote");
    local.allow_partial = remote.allow_partial = true;
    EXPECT_EQ(runJob(local, options_, {}).exit, 1);
    NotingRunner runner(remote, options_, cell_, scanOf(local));
    EXPECT_EQ(runJob(remote, options_, cell_, runner, {}).exit, 1);
    EXPECT_EQ(runner.asked, (std::vector<std::string>{"scan", "fit", "path", "motion", "accepts"}));
    for (const char* name : {"path.csv", "trajectory.csv", "pulses.csv"}) {
      EXPECT_EQ(readFile(remote.out / name), readFile(local.out / name)) << name;
    }
  }
}

TEST_F(StageRunnerTest, AScanKeptAsACloudGivesTheSamePath) {
  // What a cloud file holds is all that the path depends on: float coordinates, times, and the viewing direction.
  const JobRequest log = request("samples.csv", "log");
  runJob(log, options_, {});
  const ScanStage scanned = scanOf(log);
  geometry::Frame T_cloud_sensor = geometry::Frame::Identity();
  T_cloud_sensor.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), scanned.mean_beam).toRotationMatrix();
  std::ofstream(directory_ / "scan.pcd", std::ios::binary) << scan::formatPcd(*scanned.cloud, T_cloud_sensor);
  const JobRequest cloud = request("scan.pcd", "cloud");
  runJob(cloud, options_, {});
  EXPECT_EQ(readFile(cloud.out / "path.csv"), readFile(log.out / "path.csv"));
  EXPECT_EQ(readFile(cloud.out / "trajectory.csv"), readFile(log.out / "trajectory.csv"));
}

TEST_F(StageRunnerTest, WhatIsNotAcceptedIsNotWritten) {
  const JobRequest local = request("samples.csv", "local");
  NotingRunner runner(local, options_, cell_, scanOf(local));
  runner.wanted = false;
  EXPECT_THROW(runJob(local, options_, cell_, runner, {}), Rejected);
  EXPECT_FALSE(fs::exists(local.out));
  fs::path part = local.out;
  part += ".part";
  EXPECT_FALSE(fs::exists(part));
}

TEST_F(StageRunnerTest, RefusesToScanAMesh) {
  std::ofstream(directory_ / "part.off") << "OFF\n3 1 0\n0 0 0\n0.1 0 0\n0 0.1 0\n3 0 1 2\n";
  const JobRequest mesh = request("part.off", "out");
  try {
    scanOf(mesh);
    FAIL() << "a mesh was taken for a scan";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("part.off: is a mesh; cutting plans from a scan"));
  }
}

}  // namespace
}  // namespace scan_to_path::pipeline
