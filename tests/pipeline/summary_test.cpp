// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/summary.h"

#include <gmock/gmock.h>

namespace scan_to_path::pipeline {
namespace {

using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Summary, ShowsFiguresInUnitsPeopleUse) {
  Report report;
  report.stages = {{"scan", 100, 90, {{"no return", 10}}}};
  report.accuracy = {{"line_residual_rms", 2.5e-6, "m"},
                     {"path_row_distance_median", 4e-3, "m"},
                     {"playback_angle", 1e-5, "rad"},
                     {"duration", 95.25, "s"}};
  const auto lines = summarise(report, {}, {});
  EXPECT_THAT(lines, Contains(HasSubstr("100 in, 90 out, 10 no return")));
  EXPECT_THAT(lines, Contains(HasSubstr("2.50 um")));
  EXPECT_THAT(lines, Contains(HasSubstr("4.000 mm")));
  EXPECT_THAT(lines, Contains(HasSubstr("0.00057 deg")));
  EXPECT_THAT(lines, Not(Contains(HasSubstr("FAILED"))));
}

TEST(Summary, SaysHowMuchOfTheRowsItKnows) {
  Report report;
  report.accuracy = {{"line_noise", 2e-6, "m"}, {"between_rows_rms", 3e-6, "m"}, {"between_rows_share", 1.0, "1"}};
  EXPECT_THAT(summarise(report, {}, {}), Contains(EndsWith("noise 2.00 um, between rows RMS 3.00 um")));
  report.accuracy[2].value = 0.975;
  EXPECT_THAT(summarise(report, {}, {}), Contains(EndsWith("between rows RMS 3.00 um (over 97.5 % of them)")));
  report.accuracy[2].value = 0.0;
  EXPECT_THAT(summarise(report, {}, {}), Contains(EndsWith("noise 2.00 um, between rows unknown")));
}

TEST(Summary, TellsAFigureFromItsLimit) {
  Report report;
  report.accuracy = {{"path_scallop", 1.00007e-4, "m", 1e-4}, {"share", 0.05000004, "1", 0.05}};
  const auto lines = summarise(report, {}, {});
  EXPECT_THAT(lines, Contains(EndsWith("path_scallop is 0.10001 mm, limit 0.10000 mm")));
  EXPECT_THAT(lines, Contains(EndsWith("share is 0.05000004, limit 0.05000000")));
}

TEST(Summary, NamesWhatFailsAndCountsTheRest) {
  Report report;
  report.accuracy = {{"chord_error", 2e-5, "m", 1e-5}};
  toolpath::ToolPath path;
  path.segments = {{"row_7", std::vector<toolpath::Waypoint>(20)}};
  std::vector<toolpath::WaypointVerdict> verdicts;
  for (int i = 0; i < 20; ++i) {
    verdicts.push_back(
        {0, i, toolpath::Verdict::speed, -1.0, "rad/s", "joint_4 needs 7.9 rad/s, limit 6.3", "lower the feed"});
  }
  const auto lines = summarise(report, path, verdicts);
  EXPECT_THAT(lines, Contains(HasSubstr("chord_error is 20.00 um, limit 10.00 um")));
  EXPECT_THAT(lines,
              Contains(HasSubstr("row_7 waypoint 4: speed: joint_4 needs 7.9 rad/s, limit 6.3; lower the feed")));
  EXPECT_THAT(lines, Not(Contains(HasSubstr("waypoint 5:"))));
  EXPECT_THAT(lines, Contains(HasSubstr("20 of 20 waypoints: speed")));
}

}  // namespace
}  // namespace scan_to_path::pipeline
