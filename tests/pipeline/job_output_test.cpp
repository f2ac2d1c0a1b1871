// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/job_output.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "scan_to_path/common/text.h"
#include "small_scan.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

toolpath::ToolPath twoWaypoints() {
  toolpath::ToolPath path;
  path.process = "cutting";
  path.frame = "base_link";
  path.segments = {{"row_0", std::vector<toolpath::Waypoint>(2)}};
  return path;
}

std::vector<toolpath::WaypointVerdict> verdicts(toolpath::Verdict second) {
  return {{0, 0, toolpath::Verdict::ok, 1.0, "rad", "", ""}, {0, 1, second, 1.0, "rad", "why", "how"}};
}

TEST(JobOutput, IsBlockedByAWaypointOrATolerance) {
  JobOutput output;
  output.setPath(twoWaypoints(), verdicts(toolpath::Verdict::ok));
  output.setFigures({{"a", 1.0, "m", 2.0}});
  EXPECT_FALSE(output.isBlocked());
  output.setFigures({{"a", 3.0, "m", 2.0}});
  EXPECT_TRUE(output.isBlocked());
  EXPECT_TRUE(output.hasFailedTolerance());
  output.setFigures({{"a", 1.0, "m", 2.0}});
  EXPECT_FALSE(output.isBlocked());
  output.setPath(twoWaypoints(), verdicts(toolpath::Verdict::speed));
  EXPECT_TRUE(output.isBlocked());
  EXPECT_FALSE(output.hasFailedTolerance());
}

TEST(JobOutput, AStagePutAgainTakesItsPlace) {
  JobRequest request;
  const auto root = freshDirectory("job_output_again");
  request.input = "samples.csv";
  request.out = root / "out";
  JobOutput output;
  output.addStage({"path", 9, 8, {}}, {{"path_rows", 3.0, ""}, {"path_time", 5.0, "s"}, {"row_pitch", 1.0, "m"}}, {});
  output.dropFigures("path_");
  output.addStage({"path", 9, 7, {}}, {{"path_time", 4.0, "s"}}, {});
  output.setPath(twoWaypoints(), verdicts(toolpath::Verdict::ok));
  output.write(request, JobOptions(), Timing(), {});
  const auto report = nlohmann::json::parse(readFile(request.out / "report.json"));
  EXPECT_EQ(report["stages"].size(), 1U);
  EXPECT_EQ(report["stages"][0]["out"], 7);
  EXPECT_FALSE(report["accuracy"].contains("path_rows"));
  EXPECT_EQ(report["accuracy"]["path_time"]["value"], 4.0);
  EXPECT_TRUE(report["accuracy"].contains("row_pitch"));
  std::filesystem::remove_all(root);
}

TEST(JobOutput, WhatIsLeftOutIsNoSuccess) {
  JobRequest request;
  const auto root = freshDirectory("job_output");
  request.input = "samples.csv";
  request.out = root / "out";
  const auto written = [&](JobOutput output) {
    output.setPath(twoWaypoints(), verdicts(toolpath::Verdict::ok));
    output.addFile("program.mod", "MODULE a");
    return output.write(request, JobOptions(), Timing(), {});
  };
  EXPECT_EQ(written(JobOutput()).exit, 0);
  const toolpath::WaypointVerdict gouge = {5, 7, toolpath::Verdict::gouge, -1e-3, "m", "too deep", "a ball"};
  JobOutput partial;
  partial.setLeftOut({{"row_3", 7, Vector3(1.0, 2.0, 3.0), LeftOutKind::fails, gouge, "row_3", ""},
                      {"row_3", 8, Vector3(1.0, 2.0, 3.0), LeftOutKind::with_others, gouge, "row_3", "too short"}},
                     0.25);
  const JobResult result = written(partial);
  EXPECT_EQ(result.exit, 1);
  EXPECT_THAT(result.summary, Contains(HasSubstr("2 waypoints, 25.00 % of the planned cutting length: PARTIAL")));
  EXPECT_THAT(result.summary, Contains(HasSubstr("1 gouge, the first row_3 waypoint 7: gouge: too deep; a ball")));
  EXPECT_THAT(result.summary,
              Contains(HasSubstr("1 that do not fail themselves, the first row_3 waypoint 8: too short, "
                                 "row_3 waypoint 7 gouge: too deep; a ball")));
  EXPECT_EQ(readFile(request.out / "program.mod"), "MODULE a");
  const auto report = nlohmann::json::parse(readFile(request.out / "report.json"));
  EXPECT_EQ(report["left_out"][0]["segment"], "row_3");
  EXPECT_EQ(report["left_out"][0]["index"], 7);
  EXPECT_EQ(report["left_out"][0]["y"], 2.0);
  EXPECT_EQ(report["left_out"][0]["kind"], "fails");
  EXPECT_EQ(report["left_out"][0]["verdict"], "gouge");
  EXPECT_FALSE(report["left_out"][0].contains("caused_by"));
  EXPECT_EQ(report["left_out"][1]["kind"], "with_others");
  EXPECT_FALSE(report["left_out"][1].contains("verdict"));
  EXPECT_EQ(report["left_out"][1]["caused_by"]["index"], 7);
  EXPECT_EQ(report["summary"]["left_out"], 2);
  EXPECT_EQ(report["summary"]["left_out_share"], 0.25);
  std::filesystem::remove_all(root);
}

}  // namespace
}  // namespace scan_to_path::pipeline
