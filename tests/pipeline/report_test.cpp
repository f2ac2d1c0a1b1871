// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/report.h"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "scan_to_path/pipeline/job_options.h"

namespace scan_to_path::pipeline {
namespace {

toolpath::ToolPath onePath() {
  toolpath::ToolPath path;
  path.segments = {{"row_0", {{}, {}}}};
  return path;
}

nlohmann::json parsed(const Report& report, const std::vector<toolpath::WaypointVerdict>& verdicts) {
  JobOptions options;
  return nlohmann::json::parse(formatReport(report, fieldReferences(options), onePath(), verdicts));
}

TEST(Report, HoldsWhatTheSchemaPromises) {
  Report report;
  report.process = "cutting";
  report.stages = {{"scan", 10, 8, {{"no return", 2}}}};
  report.accuracy = {{"a", 1.23456789012e-6, "m", 2e-6}, {"b", 3.0, "s"}, {"c", 2.0, "1", 1.0}};
  const auto json = parsed(report, {{0, 0, toolpath::Verdict::ok, 0.5, "rad", "", ""},
                                    {0, 1, toolpath::Verdict::speed, -0.1, "rad/s", "too fast", "slower"}});
  EXPECT_EQ(json["stages"][0]["dropped"]["no return"], 2);
  EXPECT_EQ(json["accuracy"]["a"]["value"], 1.23456789e-6);
  EXPECT_EQ(json["accuracy"]["a"]["pass"], true);
  EXPECT_FALSE(json["accuracy"]["b"].contains("limit"));
  EXPECT_EQ(json["accuracy"]["c"]["pass"], false);
  EXPECT_EQ(json["waypoints"][1]["segment"], "row_0");
  EXPECT_EQ(json["waypoints"][1]["verdict"], "speed");
  EXPECT_EQ(json["summary"]["ok"], 1);
  EXPECT_EQ(json["summary"]["failed"], 1);
  EXPECT_EQ(json["config"]["path"]["ball_radius"], process::CuttingOptions().ball_radius);
}

TEST(Report, NumbersThatJsonLacksBecomeNull) {
  Report report;
  report.accuracy = {{"a", std::numeric_limits<double>::quiet_NaN(), "m"}};
  EXPECT_TRUE(parsed(report, {})["accuracy"]["a"]["value"].is_null());
}

TEST(Report, NotANumberNeverPasses) {
  EXPECT_FALSE((Accuracy{"a", std::numeric_limits<double>::quiet_NaN(), "m", 1.0}).pass());
  EXPECT_TRUE((Accuracy{"a", 1.0, "m", 1.0}).pass());
  EXPECT_TRUE((Accuracy{"a", 5.0, "m"}).pass());
}

TEST(Report, SaysWhereAFigureThatFailsIsLargest) {
  toolpath::ToolPath path;
  path.segments = {{"approach", {}}, {"row_7", {}}};
  const std::vector<Accuracy> figures = {{"chord_error", 2.0, "m", 1.0}, {"playback_angle", 1.0, "rad", 1.0}};
  EXPECT_EQ(worstPlaceNote(figures, "chord_error", path, {1, 3}),
            "chord_error is largest at row_7 waypoint 3, on the move that leads to it");
  EXPECT_EQ(worstPlaceNote(figures, "playback_angle", path, {1, 3}), std::nullopt);
  EXPECT_EQ(worstPlaceNote(figures, "playback_position", path, {1, 3}), std::nullopt);
}

TEST(Report, TextThatIsNotUtf8DoesNotBreakIt) {
  Report report;
  report.input_file = "part\xff.csv";
  EXPECT_NO_THROW(parsed(report, {}));
}

}  // namespace
}  // namespace scan_to_path::pipeline
