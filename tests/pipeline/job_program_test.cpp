// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/job.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "job_fixture.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::HasSubstr;

TEST_F(JobTest, FailingWaypointsLeaveNothingThatARobotCouldRun) {
  JobOptions options;
  options.path.feed = 0.9;
  options.motion.speed_fraction = 0.01;
  auto job = request("failing");
  runJob(job, {}, {});
  ASSERT_TRUE(files(job).count("program.mod"));
  const JobResult result = runJob(job, options, {});
  EXPECT_EQ(result.exit, 1);
  EXPECT_FALSE(files(job).count("program.mod")) << "an older program must not stay beside a failed plan";
  EXPECT_FALSE(files(job).count("pulses.csv"));
  EXPECT_FALSE(files(job).count("trajectory.csv"));
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("limit")));
}

TEST_F(JobTest, ALoweredFeedIsTheProgramsAndNotThePaths) {
  JobOptions options;
  options.path.feed = 0.04;
  auto plain = request("plain");
  ASSERT_EQ(runJob(plain, options, {}).exit, 0);
  options.motion.speed_fraction = 0.03;
  auto job = request("slower");
  const JobResult result = runJob(job, options, {});
  EXPECT_EQ(result.exit, 0) << ::testing::PrintToString(result.summary);
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("feed lowered at ")));
  EXPECT_EQ(file(job, "path.csv"), file(plain, "path.csv"));
  EXPECT_NE(file(job, "program.mod"), file(plain, "program.mod"));
  const auto report = nlohmann::json::parse(file(job, "report.json"));
  const auto before = nlohmann::json::parse(file(plain, "report.json"));
  EXPECT_GT(report["accuracy"]["feed_lowered"]["value"].get<double>(), 0.0);
  EXPECT_LT(report["accuracy"]["feed_least"]["value"].get<double>(), 0.04);
  EXPECT_GT(report["accuracy"]["duration"]["value"], before["accuracy"]["duration"]["value"]);
  EXPECT_EQ(before["accuracy"]["feed_lowered"]["value"], 0);
  EXPECT_FALSE(before["accuracy"].contains("feed_least"));
  options.motion.least_feed_share = 1.0;
  const JobResult strict = runJob(job, options, {});
  EXPECT_EQ(strict.exit, 1);
  EXPECT_THAT(strict.summary, ::testing::Contains(HasSubstr(" waypoints: speed")));
  EXPECT_FALSE(files(job).count("program.mod"));
}

TEST_F(JobTest, AnAirRunsFilesAreAllLiftedAndMustBeReachable) {
  JobOptions options;
  options.program.dry_offset = 0.05;
  const auto job = request("air");
  const auto real = request("real");
  const JobResult lifted = runJob(job, options, {});
  runJob(real, {}, {});
  EXPECT_EQ(lifted.exit, 0) << ::testing::PrintToString(lifted.summary);
  EXPECT_THAT(lifted.summary, ::testing::Contains(HasSubstr("lifted by 50.0 mm")));
  EXPECT_EQ(files(job), files(real));
  const auto air = toolpath::parseToolPath(file(job, "path.csv"), "path.csv");
  const auto part = toolpath::parseToolPath(file(real, "path.csv"), "path.csv");
  ASSERT_EQ(toolpath::waypointCount(air), toolpath::waypointCount(part));
  EXPECT_NEAR(air.lift.norm(), 0.05, 1e-9);
  for (std::size_t s = 0; s < air.segments.size(); ++s) {
    const auto& a = air.segments[s].waypoints.back();
    const auto& b = part.segments[s].waypoints.back();
    EXPECT_LT((a.pose.translation() - b.pose.translation() - air.lift).norm(), 4e-9);  // written to 1e-9
    EXPECT_FALSE(a.process_on);
  }
  options.program.dry_offset = 2.0;
  const JobResult result = runJob(job, options, {});
  EXPECT_EQ(result.exit, 1);
  EXPECT_FALSE(files(job).count("program.mod"));
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("in the air run")));
}

TEST_F(JobTest, APartialProgramOnlyWhenAskedForAndNeverAgainstATolerance) {
  const Groove groove;
  auto job = request("groove");
  job.input = *directory_ / "groove.csv";
  std::ofstream(job.input) << scan::formatSampleLog(smallScan(groove));
  JobOptions options = grooveOptions();
  EXPECT_EQ(runJob(job, options, {}).exit, 1);
  EXPECT_FALSE(files(job).count("program.mod"));
  job.allow_partial = true;
  const JobResult result = runJob(job, options, {});
  EXPECT_EQ(result.exit, 1);
  ASSERT_TRUE(files(job).count("program.mod")) << ::testing::PrintToString(result.summary);
  EXPECT_TRUE(files(job).count("pulses.csv"));
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("of the planned cutting length: PARTIAL")));
  EXPECT_THAT(file(job, "program.mod"), HasSubstr("PARTIAL PROGRAM: "));
  EXPECT_THAT(file(job, "program.mod"), HasSubstr("- left out: row_0 waypoints "));
  const auto report = nlohmann::json::parse(file(job, "report.json"));
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_EQ(report["summary"]["left_out"], report["left_out"].size());
  EXPECT_EQ(report["waypoints"].size(),
            toolpath::waypointCount(toolpath::parseToolPath(file(job, "path.csv"), "path.csv")));
  EXPECT_FALSE(report["accuracy"].contains("path_scallop"));
  EXPECT_FALSE(report["accuracy"].contains("path_rows"));
  EXPECT_EQ(report["accuracy"]["path_waypoints"]["value"], report["waypoints"].size());
  EXPECT_EQ(report["stages"][2]["name"], "path");
  EXPECT_EQ(report["stages"][2]["out"], report["waypoints"].size());
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr(" % of the cutting")));
  const double share = report["summary"]["left_out_share"];
  EXPECT_GT(share, 0.1);
  EXPECT_LT(share, 0.9);
  options.report.max_line_residual = 1e-9;
  EXPECT_EQ(runJob(job, options, {}).exit, 1);
  EXPECT_EQ(files(job), (std::set<std::string>{"path.csv", "report.json", "timing.json"}));
}

TEST_F(JobTest, AnAirRunOfAPartialProgramFailsAsAWhole) {
  const Groove groove;
  auto job = request("groove_air");
  job.input = *directory_ / "groove_air.csv";
  std::ofstream(job.input) << scan::formatSampleLog(smallScan(groove));
  job.allow_partial = true;
  JobOptions options = grooveOptions();
  options.program.dry_offset = 0.05;
  EXPECT_EQ(runJob(job, options, {}).exit, 1);
  EXPECT_TRUE(files(job).count("program.mod"));
  options.program.dry_offset = 2.0;
  const JobResult result = runJob(job, options, {});
  EXPECT_EQ(result.exit, 1);
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("fail in its air run: lower program.dry_offset")));
  EXPECT_EQ(files(job), (std::set<std::string>{"path.csv", "report.json", "timing.json"}));
}

TEST_F(JobTest, NothingLeftIsNoPartialProgram) {
  JobOptions options;
  options.path.feed = 0.9;
  options.motion.speed_fraction = 0.01;
  auto job = request("nothing");
  job.allow_partial = true;
  const JobResult result = runJob(job, options, {});
  EXPECT_EQ(result.exit, 1);
  EXPECT_THAT(result.summary, ::testing::Contains(HasSubstr("nothing is left of the path")));
  EXPECT_EQ(files(job), (std::set<std::string>{"path.csv", "report.json", "timing.json"}));
}

// Every pass begins where the last one's wrist can get back to.
TEST_F(JobTest, PassesOverStockGiveAProgram) {
  for (const int passes : {2, 3}) {
    JobRequest several = request("passes_" + std::to_string(passes));
    JobOptions options;
    options.path.stock = 1e-3 * passes;
    EXPECT_EQ(runJob(several, options, {}).exit, 0) << passes;
    EXPECT_THAT(file(several, "path.csv"), HasSubstr("pass_" + std::to_string(passes - 1) + "_row_0"));
    EXPECT_TRUE(files(several).count("program.mod") == 1);
  }
}
}  // namespace
}  // namespace scan_to_path::pipeline
