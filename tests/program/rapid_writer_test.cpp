// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/rapid_writer.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <sstream>

#include "program_cases.h"
#include "scan_to_path/program/rapid_names.h"
#include "scan_to_path/program/rapid_reader.h"
#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

using test::seededInput;
using ::testing::HasSubstr;
using ::testing::Not;

std::string mainModule(const ProgramInput& input) { return writeRapid(input).at(1).content; }

/// One row of four waypoints in the base frame, its tool the flange, joint angles given.
ProgramInput plainInput() {
  ProgramInput input;
  input.robot = test::irb2400WithLinkage();
  input.path.process = "cutting";
  input.path.segments.push_back({"row_0", {}});
  for (int i = 0; i < 4; ++i) {
    test::addWaypoint(input, test::joints({-10.0 + i, 20, 15, 100, -40, -95}), 0.02, i == 2);
  }
  return input;
}

TEST(RapidWriter, SameInputSameBytes) {
  const auto a = writeRapid(seededInput(1));
  const auto b = writeRapid(seededInput(1));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].content, b[i].content);
}

// At all joints zero the flange of the IRB 2400 is at (940, 0, 1455) mm and looks along +x, its x down: a quarter turn
// about y, w = y = 0.70710678.
TEST(RapidWriter, WritesMillimetresAndScalarFirstQuaternions) {
  auto input = plainInput();
  input.path.segments[0].waypoints.clear();
  input.plan = {};
  test::addWaypoint(input, test::joints({0, 0, 0, 0, 0, 0}), 0.02, false);
  EXPECT_THAT(mainModule(input), HasSubstr("MoveL [[940.0000,0.0000,1455.0000],\n"
                                           "      [0.70710678,0.00000000,0.70710678,0.00000000],[0,0,0,0],"));
}

TEST(RapidWriter, WritesAxesInDegreesAndConfiguration) {
  const auto text = mainModule(plainInput());
  EXPECT_THAT(text, HasSubstr("[-10.000000,20.000000,35.000000,100.000000,-40.000000,-95.000000]"));
  EXPECT_THAT(text, HasSubstr(",[-1,1,-2,1],\n"));
  EXPECT_THAT(text, HasSubstr("feed_2 := [20.000,"));
  auto serial = plainInput();
  serial.robot.coupled_axis.reset();
  EXPECT_THAT(mainModule(serial), HasSubstr("[-10.000000,20.000000,15.000000,"));
}

// Half turns and turns just short of one, about all axes: w near zero is where conversions go wrong.
TEST(RapidWriter, QuaternionsNearHalfTurns) {
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    auto input = plainInput();
    const geometry::Vector3 axis =
        i < 3 ? geometry::Vector3::Unit(i) : geometry::Vector3(random.gaussian(), random.gaussian(), random.gaussian());
    const double angle = M_PI + (i % 3 - 1) * std::pow(10.0, -random.uniform(1.0, 12.0));
    auto& pose = input.path.segments[0].waypoints[1].pose;
    pose.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    const auto program = readRapid(writeRapid(input));
    // Rounding of four components by 5e-9 turns by 4 * 5e-9 at most.
    EXPECT_LT(geometry::rotationAngle(program.moves[2].T_base_tcp.linear(), pose.linear()), 2e-8);
  }
}

TEST(RapidWriter, StopsAtSegmentEnds) {
  const auto input = seededInput(5);
  const auto program = readRapid(writeRapid(input));
  std::size_t at = 1;
  int blends = 0;
  for (const auto& segment : input.path.segments) {
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i, ++at) {
      const bool end = i + 1 == segment.waypoints.size();
      if (end) {
        EXPECT_TRUE(program.moves[at].stop) << segment.name << " " << i;
      }
      blends += program.moves[at].stop ? 0 : 1;
    }
  }
  EXPECT_GT(blends, 60);
}

// A spindle that stands, or speeds up on the part, spoils it: it runs before the tool comes down and until it is off.
TEST(RapidWriter, TheProcessRunsFromBeforeARowUntilAfterIt) {
  auto input = seededInput(7, 2, 12);
  input.options.process_signal = "do_spindle";
  const auto files = writeRapid(input);
  const auto program = readRapid(files);
  std::size_t at = 1;
  for (const auto& segment : input.path.segments) {
    const bool row = segment.name.rfind("row", 0) == 0;
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i, ++at) {
      EXPECT_EQ(program.moves[at].process_on, row) << segment.name << " " << i;
    }
  }
  const std::string& text = files[1].content;
  const auto routine = text.find("PROC s1_row_0_1()");
  ASSERT_NE(routine, std::string::npos);
  EXPECT_LT(text.find("ProcessOn;", routine), text.find("MoveL", routine)) << "the plunge to the row's first waypoint";
  EXPECT_TRUE(readBack(Controller::abb, input, files).discrepancies.empty());
}

TEST(RapidWriter, AnAirRunsProgramIsOnTheLiftedPath) {
  auto input = seededInput(6);
  for (auto& segment : input.path.segments) {
    for (auto& waypoint : segment.waypoints) waypoint.process_on = false;
  }
  input.options.dry_offset = 0.05;
  input.path.lift = 0.05 * geometry::Vector3::UnitZ();
  const auto program = readRapid(writeRapid(input));
  EXPECT_TRUE(
      std::none_of(program.moves.begin(), program.moves.end(), [](const auto& move) { return move.process_on; }));
  EXPECT_TRUE(readBack(Controller::abb, input, writeRapid(input)).discrepancies.empty());
  EXPECT_THAT(mainModule(input), HasSubstr("AIR RUN: the whole path is shifted by 50.000 mm"));
  EXPECT_THAT(mainModule(input), HasSubstr("dry_run := TRUE"));
  EXPECT_THAT(mainModule(seededInput(6)), HasSubstr("dry_run := FALSE"));
}

TEST(RapidWriter, ProcessRoutinesSetTheSignalButNotInAnAirRun) {
  auto input = plainInput();
  EXPECT_THAT(mainModule(input), Not(HasSubstr("SetDO")));
  input.options.process_signal = "doSpindle";
  EXPECT_THAT(mainModule(input), HasSubstr("IF NOT dry_run THEN\n      SetDO doSpindle,1;\n    ENDIF"));
  EXPECT_THAT(mainModule(input), HasSubstr("    SetDO doSpindle,0;"));
}

TEST(RapidWriter, WaitsForTheSpindleOnlyWhenASignalStartsIt) {
  auto input = plainInput();
  EXPECT_THAT(mainModule(input), Not(HasSubstr("WaitTime")));
  input.options.process_signal = "doSpindle";
  EXPECT_THAT(mainModule(input), HasSubstr("SetDO doSpindle,1;\n    ENDIF\n    WaitTime 1.000;\n  ENDPROC"));
  input.options.process_delay = 2.5;
  const auto waits = [&input] {
    RapidReadOptions options;
    options.process_signal = input.options.process_signal;
    std::vector<double> list;
    for (const auto& move : readRapid(writeRapid(input), options).moves) list.push_back(move.process_wait);
    return list;
  };
  EXPECT_EQ(waits(), (std::vector<double>{0, 0, 2.5, 0, 0}));  // off the first waypoint, on to the rest of the row
  input.options.process_delay = 0.0;
  EXPECT_THAT(mainModule(input), Not(HasSubstr("WaitTime")));
  input.options.process_delay = -1.0;
  test::expectInputError([&] { writeRapid(input); }, "program.process_delay is -1 s, must be in [0, 600]");
}

TEST(RapidWriter, HeaderHasNoticeProvenanceAndComments) {
  auto input = plainInput();
  input.provenance = {"input: B\xc3\xbcgel\nENDMODULE.csv"};
  input.options.comments = {"for fixture 3"};
  input.notices = {"PARTIAL PROGRAM"};
  const auto text = mainModule(input);
  for (const char* part : {"SAFETY", "NOT checked", "dry_offset", "reduced", "responsible",
                           "! input: B??gel?ENDMODULE.csv", "! for fixture 3", "! PARTIAL PROGRAM", "Units: mm"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
}

TEST(RapidWriter, LinesFitInEightyColumns) {
  for (const auto& file : writeRapid(seededInput(7, 2, 10))) {
    std::istringstream lines(file.content);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  }
}

TEST(RapidWriter, HugePathsAreSplit) {
  const auto input = seededInput(9, 3, 1700);
  const auto files = writeRapid(input);
  // Routines of 3 | 6 x 250, 200 | 3 moves a row; filled up by hand to 1000 a module: 753, 956, 1000, 956, 1000, 453.
  ASSERT_EQ(files.size(), 1 + 6u);
  EXPECT_EQ(files[0].name, "program.pgf");
  std::set<std::string> routines;
  for (std::size_t i = 1; i < files.size(); ++i) {
    EXPECT_THAT(files[0].content, HasSubstr("<Module>" + files[i].name + "</Module>"));
    std::istringstream lines(files[i].content);
    int in_module = 0;
    int in_routine = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.find("  PROC ") == 0) {
        in_routine = 0;
        const std::string name = line.substr(7, line.find('(') - 7);
        EXPECT_TRUE(name == "main" || isRapidName(name)) << name;
        EXPECT_TRUE(routines.insert(name).second) << name;
      }
      if (line.find("    MoveL ") != 0) continue;
      EXPECT_LE(++in_routine, 250);
      EXPECT_LE(++in_module, 1000);
    }
  }
  EXPECT_TRUE(readBack(Controller::abb, input, files).discrepancies.empty());
}

TEST(RapidWriter, EveryWaypointNeedsJointAngles) {
  auto input = seededInput(10, 1, 12);
  auto& points = input.plan.trajectory.points;
  const auto files = writeRapid(input);
  points.erase(points.begin() + 8, points.begin() + 10);
  test::expectInputError([&] { writeRapid(input); }, "segment row_0 (1) waypoint 5: joint solution is missing");
  const auto found = readBack(Controller::abb, input, files).discrepancies;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].segment, 1);
  EXPECT_EQ(found[0].index, 5);
}

TEST(RapidWriter, IntermediateTrajectoryPointsAreNotWaypoints) {
  auto input = plainInput();
  auto& points = input.plan.trajectory.points;
  auto between = points[1];
  between.q[0] += 0.1;
  points.insert(points.begin() + 1, between);
  EXPECT_EQ(mainModule(input), mainModule(plainInput()));
  EXPECT_TRUE(readBack(Controller::abb, input, writeRapid(input)).discrepancies.empty());
}

TEST(RapidWriter, RefusesWhatIsNoProgram) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::pair<const char*, std::function<void(ProgramInput&)>> cases[] = {
      {"segment row_0 (0) waypoint 2: pose is not finite",
       [nan](auto& i) { i.path.segments[0].waypoints[2].pose.translation().y() = nan; }},
      {"waypoint 2: rotation", [](auto& i) { i.path.segments[0].waypoints[2].pose.linear() *= 1.001; }},
      {"waypoint 2: rotation", [](auto& i) { i.path.segments[0].waypoints[2].pose.linear().col(0) *= -1.0; }},
      {"waypoint 2: coordinate", [](auto& i) { i.path.segments[0].waypoints[2].pose.translation().x() = 850.0; }},
      {"waypoint 1: joint angle is not finite", [inf](auto& i) { i.plan.trajectory.points[1].q[3] = inf; }},
      {"waypoint 1: number of joint angles is 5", [](auto& i) { i.plan.trajectory.points[1].q.conservativeResize(5); }},
      {"waypoint 3: feed is 0.000000 m/s", [](auto& i) { i.plan.feeds[3] = 0.0; }},
      {"waypoint 3: feed is not finite", [nan](auto& i) { i.plan.feeds[3] = nan; }},
      {"waypoint 3: feed is 20.000000 m/s", [](auto& i) { i.plan.feeds[3] = 20.0; }},
      {"waypoint 3: feed is 0.020000 m/s, must be at most the path's 0.019999 m/s",
       [](auto& i) { i.path.segments[0].waypoints[3].feed = 0.019999; }},
      {"waypoint 3: feed is 0.020000 m/s", [nan](auto& i) { i.path.segments[0].waypoints[3].feed = nan; }},
      {"number of feeds is 3, must be one for each of 4 waypoints", [](auto& i) { i.plan.feeds.pop_back(); }},
      {"waypoint 0: process is on", [](auto& i) { i.path.segments[0].waypoints[0].process_on = true; }},
      {"the path has no such waypoint", [](auto& i) { i.plan.trajectory.points[1].index = 4; }},
      {"tool mount: pose is not finite", [nan](auto& i) { i.T_tip_tcp.translation().x() = nan; }},
      {"work object: pose is not finite", [nan](auto& i) { i.T_base_workobject.linear()(0, 0) = nan; }},
      {"program.tool_mass", [](auto& i) { i.options.tool_mass = -1.0; }},
      {"must be 6", [](auto& i) { i.robot.joints.pop_back(); }},
      {"has no waypoint", [](auto& i) { i.path.segments.clear(), i.plan = {}; }},
  };
  for (const auto& [message, spoil] : cases) {
    auto input = plainInput();
    spoil(input);
    test::expectInputError([&in = input] { writeRapid(in); }, message);
  }
}

TEST(RapidWriter, SegmentNamesCannotBreakOut) {
  auto input = plainInput();
  input.path.segments[0].name = "x()\nENDPROC\nMoveL ; \xff a very long name that goes on and on and on";
  const auto text = mainModule(input);
  EXPECT_THAT(text, HasSubstr("PROC s0_xENDPROCMoveLaverylongnamet_1()"));
  EXPECT_TRUE(readBack(Controller::abb, input, writeRapid(input)).discrepancies.empty());
}

}  // namespace
}  // namespace scan_to_path::program
