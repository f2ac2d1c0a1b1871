// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <regex>

#include "program_cases.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/program/program.h"
#include "scan_to_path/program/rapid_reader.h"

namespace scan_to_path::program {
namespace {

using test::seededInput;
using ::testing::HasSubstr;

std::vector<ProgramFile> written(const ProgramInput& input) { return writeProgram(Controller::abb, input); }

std::string texts(const std::vector<Discrepancy>& found) {
  std::string text;
  for (const auto& discrepancy : found) text += discrepancy.text + "\n";
  return text;
}

std::string textsOf(const ProgramInput& input, const std::vector<ProgramFile>& files) {
  return texts(readBack(Controller::abb, input, files).discrepancies);
}

TEST(ReadBack, SeededProgramsSayWhatWasPlanned) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto input = seededInput(seed);
    EXPECT_EQ(textsOf(input, written(input)), "") << "seed " << seed;
    EXPECT_EQ(readBack(Controller::abb, input, written(input)).waypoints, toolpath::waypointCount(input.path));
  }
}

TEST(ReadBack, SplitProgramsAndSignalsToo) {
  auto input = seededInput(4, 6, 70);
  input.options.moves_per_routine = 16;
  input.options.moves_per_module = 50;
  input.options.process_signal = "doSpindle";
  input.options.monitor_configuration = true;
  EXPECT_GT(written(input).size(), 8u);
  EXPECT_EQ(textsOf(input, written(input)), "");
}

/// Replaces the first match after `from`.
std::vector<ProgramFile> changed(std::vector<ProgramFile> files, const std::string& pattern, const std::string& by,
                                 const std::string& from = "") {
  auto& text = files.at(1).content;
  const std::size_t begin = from.empty() ? 0 : text.find(from);
  EXPECT_NE(begin, std::string::npos) << from;
  const std::string after =
      std::regex_replace(text.substr(begin), std::regex(pattern), by, std::regex_constants::format_first_only);
  EXPECT_NE(after, text.substr(begin)) << pattern;
  text = text.substr(0, begin) + after;
  return files;
}

// One slip at a time in the written text: each must be seen, and called by its name.
TEST(ReadBack, MutationTwinsAreFound) {
  const auto input = seededInput(2, 2, 12);
  const auto files = written(input);
  ASSERT_EQ(textsOf(input, files), "");
  const std::string row = "PROC s1_row_0_1";
  const std::string number = "(-?\\d+\\.\\d+)";
  const struct {
    const char* what;
    std::string pattern, by, from, message;
  } cases[] = {
      {"a sign", "MoveL \\[\\[-?", "MoveL [[9", row, "um off the plan"},
      {"a unit", "MoveL \\[\\[(-?\\d+)\\d\\.", "MoveL [[$1.", row, "um off the plan"},
      {"w last instead of first", "\\n      \\[" + number + "," + number + "," + number + "," + number + "\\]",
       "\n      [$2,$3,$4,$1]", row, "deg off the plan"},
      {"conjugated", "\\n      \\[" + number + ",(-?)", "\n      [-$1,$2", row, "deg off the plan"},
      {"a quadrant", "\\],\\[(-?\\d),", "],[3,", row, "quadrant of axis 1"},
      {"cfx", ",(\\d)\\],\\n", ",8],\n", row, "cfx"},
      {"feed of another kind", "feed_3", "feed_2", row, "feed is"},
      {"feed in m/s", "feed_4 := \\[30\\.000", "feed_4 := [0.030", "", "feed is"},
      {"orientation speed", "feed_4 := \\[30\\.000,200", "feed_4 := [30.000,100", "", "orientation speed"},
      {"process not switched on", "ProcessOn;", "", row, "process is off, planned on"},
      {"process switched on at the contact only", "ProcessOn;\\s*(MoveL [^;]*;)", "$1 ProcessOn;", row,
       "process is off, planned on"},
      {"process not switched off", "ProcessOff;", "", row, "process is on, planned off"},
      {"a blend too large", "zone_\\w+um", "z10", row, "zone of 10.000 mm"},
      {"a blend where the process starts", "fine", "z0", row, "no stop where the process is switched"},
      {"a move left out", "MoveL [^;]*;", "", row, "moves, the plan needs"},
      {"two moves exchanged", "(MoveL [^;]*;)\\s*(MoveL [^;]*;)", "$2$1", row, "um off the plan"},
      {"joint interpolation", "MoveL", "MoveJ", row, "not linear"},
      {"start angle", "start_axes := \\[\\s*\\[(-?)\\d", "start_axes := [[$019", "", "start angle of joint 1"},
      {"no start", "MoveAbsJ [^;]*;", "", "", "moves, the plan needs"},
      {"tool frame", "tooldata tool_scan := \\[TRUE,\\s*\\[\\[", "tooldata tool_scan := [TRUE,[[1", "", "tool frame"},
      {"mass", "\\[5\\.000,", "[50.000,", "", "tool load"},
      {"centre of gravity", "100\\.0000\\],\\[1,0", "10.0000],[1,0", "", "tool load"},
      {"work object", "wobjdata wobj_scan := ([^.]*\\.\\d)", "wobjdata wobj_scan := $011", "", "um off the plan"},
      {"an unplanned stop", "MoveL", "Stop; MoveL", row, "unplanned stop"},
      {"a text that is no RAPID", "ENDPROC", "", row, "line "},
  };
  for (const auto& item : cases) {
    std::string by = item.by;
    const auto found = textsOf(input, changed(files, item.pattern, by, item.from));
    EXPECT_FALSE(found.empty()) << item.what;
    EXPECT_THAT(found, HasSubstr(item.message)) << item.what;
  }
}

TEST(ReadBack, NamesSegmentAndWaypoint) {
  const auto input = seededInput(2, 2, 12);
  const auto found =
      readBack(Controller::abb, input, changed(written(input), "MoveL \\[\\[-?", "MoveL [[9", "PROC s1_row_0_1"))
          .discrepancies;
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].segment, 1);
  EXPECT_EQ(found[0].index, 0);
  EXPECT_THAT(found[0].text, HasSubstr("program.mod line "));
}

// The plan changes, the text does not.
TEST(ReadBack, NoticesAnotherPlan) {
  const auto input = seededInput(3);
  const auto files = written(input);
  const auto expectFound = [&](const char* what, const ProgramInput& other, const std::string& message) {
    EXPECT_THAT(textsOf(other, files), HasSubstr(message)) << what;
  };
  auto other = input;
  other.path.segments[1].waypoints[5].pose.translation().x() += 1.2e-6;
  expectFound("1.2 um", other, "limit 1 um");
  other = input;
  other.path.segments[1].waypoints[5].pose.rotate(Eigen::AngleAxisd(2.1e-5, geometry::Vector3::UnitZ()));
  expectFound("0.0012 degrees", other, "limit 0.001 deg");
  other = input;
  for (auto& segment : other.path.segments) {
    for (auto& waypoint : segment.waypoints) waypoint.pose.translation().z() += 0.05;
  }
  expectFound("a path lifted by 50 mm", other, "um off the plan");
  other = input;
  for (auto& waypoint : other.path.segments[1].waypoints) waypoint.process_on = false;
  expectFound("process", other, "process is on, planned off");
  other = input;
  other.plan.trajectory.points[0].q[2] += 1e-6;
  expectFound("start angle", other, "start angle of joint 3");
  other = input;
  other.robot.coupled_axis.reset();
  expectFound("axis 3 convention", other, "start angle of joint 3");
  other = input;
  other.T_tip_tcp.translation().z() += 1e-4;
  expectFound("tool mount", other, "tool frame");
  other = input;
  other.path.segments.back().waypoints.pop_back();
  other.plan.trajectory.points.pop_back();
  other.plan.feeds.pop_back();
  expectFound("a waypoint less", other, "moves, the plan needs");
}

TEST(ReadBack, FeedsAreThePlansAndNeverAboveThePaths) {
  auto input = seededInput(3);
  const auto asked = written(input);
  auto& feeds = input.plan.feeds;
  for (std::size_t i = 10; i < 30; ++i) feeds[i] = 0.0123;
  const auto lowered = written(input);
  EXPECT_EQ(textsOf(input, lowered), "");
  EXPECT_THAT(textsOf(input, asked), HasSubstr("feed is 0.030000 m/s, planned 0.012300 m/s"));
  // The twins: a plan that is lowered elsewhere, one that goes faster than the path, one that lacks a feed.
  std::swap(feeds[9], feeds[10]);
  EXPECT_THAT(textsOf(input, lowered), HasSubstr("feed is 0.012300 m/s, planned 0.030000 m/s"));
  std::swap(feeds[9], feeds[10]);
  for (auto& waypoint : input.path.segments[1].waypoints) waypoint.feed = std::min(waypoint.feed, 0.0122);
  EXPECT_THAT(textsOf(input, lowered), HasSubstr("feed is 0.012300 m/s, the path asks for 0.012200 m/s at most"));
  feeds.pop_back();
  EXPECT_THAT(textsOf(input, lowered), HasSubstr("feeds for 138 waypoints"));
}

// Joint angles that do not belong to the pose: the writer cannot know, forward kinematics of what was read can.
TEST(ReadBack, StartAnglesMustReachTheStartPose) {
  auto input = seededInput(3);
  input.plan.trajectory.points[0].q[5] += 1e-3;
  EXPECT_THAT(textsOf(input, written(input)), HasSubstr("off the first target"));
}

TEST(ReadBack, NoticesAxisThreeOutOfTheControllersRange) {
  auto input = seededInput(3, 1, 4);
  auto& point = input.plan.trajectory.points[5];
  point.q[1] += 1.4;
  point.q[2] += 0.3;
  EXPECT_THAT(textsOf(input, written(input)), HasSubstr("axis 3 would stand at"));
  // Each joint is within its own range: without the declaration only the elbow's counts.
  ASSERT_GT(robot::limitMargin(test::irb2400(), point.q), 0.0);
  input.robot.coupled_axis.reset();
  EXPECT_THAT(textsOf(input, written(input)), ::testing::Not(HasSubstr("would stand at")));
  point.q[3] = 3.6;
  EXPECT_THAT(textsOf(input, written(input)),
              HasSubstr("axis 4 would stand at 206.265 deg on the controller, limits -200.0"));
}

TEST(ReadBack, NoticesAToolThatDoesNotWaitForItsSpindle) {
  auto input = seededInput(4);
  input.options.process_signal = "doSpindle";
  input.options.process_delay = 3.0;
  const auto files = written(input);
  ASSERT_EQ(textsOf(input, files), "");
  const std::string message = "the process runs for 1.000 s before the tool moves on, planned 3.000 s";
  EXPECT_THAT(textsOf(input, changed(files, "WaitTime 3", "WaitTime 1")), HasSubstr(message));
  EXPECT_THAT(textsOf(input, changed(files, "WaitTime 3.000;", "")), HasSubstr("runs for 0.000 s"));
  EXPECT_THAT(textsOf(input, changed(files, "(IF NOT[^W]*)(WaitTime 3.000;)", "$2 $1")), HasSubstr("runs for 0.000 s"));
}

TEST(ReadBack, PlansForOtherArmsAreNotCompared) {
  auto input = seededInput(3);
  const auto files = written(input);
  input.plan.trajectory.points[4].q.conservativeResize(5);
  EXPECT_THAT(textsOf(input, files), HasSubstr("not for six axes"));
}

TEST(ReadBack, ListsAtMostTheLimit) {
  auto input = seededInput(3);
  const auto files = written(input);
  input.T_base_path.translation().x() += 0.1;
  EXPECT_EQ(readBack(Controller::abb, input, files, 7).discrepancies.size(), 7u);
}

/// Every decimal number of the text as a 32-bit float has it, which is what a controller computes with.
std::vector<ProgramFile> inSinglePrecision(std::vector<ProgramFile> files) {
  const std::regex decimal("-?\\d+\\.\\d+");
  for (auto& file : files) {
    if (file.name == "program.pgf") continue;
    std::string text;
    auto at = file.content.cbegin();
    for (std::sregex_iterator i(file.content.begin(), file.content.end(), decimal), end; i != end; ++i) {
      text.append(at, (*i)[0].first);
      text += fixed(static_cast<double>(std::stof(i->str())), 12);
      at = (*i)[0].second;
    }
    file.content = text.append(at, file.content.cend());
  }
  return files;
}

// A float has 24 bits: 6e-5 mm at 1 m, 4e-6 degrees at 100 degrees.
TEST(ReadBack, SinglePrecisionControllersStayWithinTheBars) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto input = seededInput(seed);
    EXPECT_EQ(textsOf(input, inSinglePrecision(written(input))), "") << "seed " << seed;
  }
}

// What the digits cost: worst position and angle over 20 seeds, against the rounding of 1e-4 mm (0.09 um over three
// axes) and of 1e-8 in the quaternion (4e-8 rad), in target, work object and, times 2 m of reach, its orientation.
TEST(ReadBack, WrittenPosesAreRoundedOnly) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto input = seededInput(seed);
    const auto program = readRapid(written(input));
    std::size_t at = 1;
    for (const auto& segment : input.path.segments) {
      for (const auto& waypoint : segment.waypoints) {
        const auto planned = input.T_base_path * waypoint.pose * input.path.T_contact_tcp;
        const auto& found = program.moves[at++].T_base_tcp;
        ASSERT_LT((found.translation() - planned.translation()).norm(), 0.09e-6 + 0.09e-6 + 2.0 * 4e-8);
        ASSERT_LT(geometry::rotationAngle(found.linear(), planned.linear()), 2 * 4e-8);
      }
    }
  }
}

}  // namespace
}  // namespace scan_to_path::program
