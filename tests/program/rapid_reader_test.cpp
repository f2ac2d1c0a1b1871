// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/rapid_reader.h"

#include <gtest/gtest.h>

#include <string>

#include "program_cases.h"
#include "scan_to_path/common/text.h"
#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

using geometry::Vector3;

RapidProgram handWritten() {
  RapidReadOptions options;
  options.process_signal = "doSpindle";
  const auto file = std::string(SCAN_TO_PATH_SOURCE_DIR) + "/tests/program/fixtures/hand_written.mod";
  return readRapid({{"hand_written.mod", readFile(file)}}, options);
}

// Worked out by hand. Work object in the base: user frame turned 90 degrees about z (x to y, y to -x), at (500, 200,
// 300); the object frame's (10, 20, 30) lies along (-20, 10, 30) there: origin (480, 210, 330), x along base y, y along
// base -x. Target A (100, 0, 50) is then (480, 310, 380); its orientation, half a turn about the object's x, has its x
// along base y, its y along base x, its z down.
TEST(RapidReader, UnderstandsAProgrammersModule) {
  const auto program = handWritten();
  ASSERT_EQ(program.moves.size(), 6u);
  const struct {
    RapidMoveType type;
    Vector3 position;  // [mm]
    double speed;      // [mm/s]
    double zone;       // [mm]
    bool process_on;
    int line;
  } expected[] = {
      {RapidMoveType::absolute_joint, {0, 0, 0}, 500, 0, false, 22},
      {RapidMoveType::joint, {485, 315, 390}, 200, 10, false, 24},    // A + (5, -5, 10): (-(-5), 5, 10) in the base
      {RapidMoveType::linear, {480, 310, 380}, 12.5, 0, false, 36},   // A
      {RapidMoveType::linear, {480, 460, 380}, 12.5, 0.3, true, 41},  // B: 250 along base y
      {RapidMoveType::linear, {485, 460, 380}, 12.5, 0, true, 42},    // B - 5 along the object's y
      {RapidMoveType::linear, {480, 460, 410}, 35, 0, false, 30},     // B back along the tool's z, which points down
  };
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    const auto& move = program.moves[i];
    EXPECT_EQ(move.type, expected[i].type) << i;
    EXPECT_LT((1e3 * move.T_base_tcp.translation() - expected[i].position).norm(), 1e-5) << i;
    EXPECT_DOUBLE_EQ(1e3 * move.speed, expected[i].speed) << i;
    EXPECT_DOUBLE_EQ(1e3 * move.zone, expected[i].zone) << i;
    EXPECT_EQ(move.stop, expected[i].zone == 0.0) << i;
    EXPECT_EQ(move.process_on, expected[i].process_on) << i;
    EXPECT_EQ(move.line, expected[i].line) << i;
  }
  Eigen::Matrix3d R;
  R << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  for (std::size_t i = 1; i < 6; ++i) {
    // 0.70710678 is off by 1.2e-9 from the half root, and so is the matrix at most by a few of that.
    EXPECT_LT((program.moves[i].T_base_tcp.linear() - R).norm(), 1e-8) << i;
  }
  const double axes[] = {0, -30, 30, 0, 60, 90};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(program.moves[0].axes[i], test::degree * axes[i], 1e-12);
  EXPECT_EQ(program.moves[3].configuration, (std::array<int, 4>{0, -1, 1, 1}));
  EXPECT_NEAR(program.moves[3].orientation_speed, 50 * test::degree, 1e-12);
}

TEST(RapidReader, ReadsToolAndLoad) {
  const auto program = handWritten();
  ASSERT_EQ(program.tools.size(), 2u);
  const auto& tool = program.tools[program.moves[2].tool];
  EXPECT_EQ(tool.name, "tspindle");
  // A quarter turn about y: the tool's z along the flange's x, its x along the flange's -z.
  EXPECT_LT((tool.T_tip_tcp.linear().col(2) - Vector3::UnitX()).norm(), 1e-6);
  EXPECT_LT((tool.T_tip_tcp.linear().col(0) + Vector3::UnitZ()).norm(), 1e-6);
  EXPECT_LT((tool.T_tip_tcp.translation() - Vector3(0, 0, 0.15)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(tool.mass, 4.2);
  EXPECT_LT((tool.centre_of_gravity - Vector3(0.012, -0.003, 0.0855)).norm(), 1e-12);
  EXPECT_EQ(program.tools[program.moves[5].tool].name, "tool0");
  EXPECT_TRUE(program.tools[program.moves[5].tool].T_tip_tcp.matrix().isIdentity());
}

std::string inMain(const std::string& statements, const std::string& data = "") {
  return "MODULE M\n" + data + "\nPROC main()\n" + statements + "\nENDPROC\nENDMODULE\n";
}

const std::string target = "[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
const std::string move = "MoveL " + target + ",v100,fine,tool0;";

TEST(RapidReader, PredefinedSpeedsAndZones) {
  for (const auto& [text, speed, zone] : {std::tuple{"v5,z0", 0.005, 0.3e-3}, std::tuple{"v7000,z200", 7.0, 0.2}}) {
    const auto program = readRapid({{"m.mod", inMain("MoveL " + target + "," + text + ",tool0;")}});
    EXPECT_DOUBLE_EQ(program.moves.at(0).speed, speed);
    EXPECT_DOUBLE_EQ(program.moves.at(0).zone, zone);
  }
}

TEST(RapidReader, SequenceStopsAndModules) {
  const std::string second = "MODULE N\nPROC Second()\n" + move + "\nStop;\nEXIT;\nENDPROC\nENDMODULE";
  const auto program =
      readRapid({{"x.pgf", "not RAPID"}, {"m.mod", inMain("Stop;" + move + "Second;" + move)}, {"n.MOD", second}});
  ASSERT_EQ(program.moves.size(), 2u);
  EXPECT_TRUE(program.moves[0].after_stop);
  EXPECT_FALSE(program.moves[1].after_stop);
  EXPECT_EQ(program.moves[1].file, "n.MOD");
}

TEST(RapidReader, CountsWaitsWhileTheProcessRuns) {
  const auto waitBefore = [](const std::string& statements, const std::string& routine,
                             const std::string& signal = "do1") {
    RapidReadOptions options;
    options.process_signal = signal;
    const std::string text = "MODULE M\nCONST num long:=3;\nPROC main()\n" + statements + move + move +
                             "\nENDPROC\nPROC ProcessOn()\n" + routine + "\nENDPROC\nENDMODULE\n";
    const auto program = readRapid({{"m.mod", text}}, options);
    EXPECT_EQ(program.moves.at(1).process_wait, 0.0) << "of the first move only";
    return program.moves.at(0).process_wait;
  };
  EXPECT_EQ(waitBefore("ProcessOn;", "SetDO do1,1; WaitTime 0.5; WaitTime\\InPos,long/2;"), 2.0);
  EXPECT_EQ(waitBefore("ProcessOn; WaitTime long;", "IF x THEN SetDO do1,1; ENDIF"), 3.0);
  EXPECT_EQ(waitBefore("ProcessOn;", "WaitTime 5; IF x THEN SetDO do1,1; ENDIF"), 0.0) << "before the signal";
  EXPECT_EQ(waitBefore("ProcessOn;", "SetDO do1,1; IF x THEN WaitTime 5; ENDIF"), 0.0) << "perhaps";
  EXPECT_EQ(waitBefore("ProcessOn;", "SetDO do1,1; RETURN; WaitTime 5;"), 0.0) << "never reached";
  EXPECT_EQ(waitBefore("ProcessOn;", "WaitTime 5;", ""), 5.0);
  EXPECT_EQ(waitBefore("Set do1; WaitTime 0.25;", ""), 0.25);
  EXPECT_EQ(waitBefore("WaitTime 7; Set do1;", ""), 0.0);
  EXPECT_EQ(waitBefore("WaitTime 7;", ""), 0.0) << "process off";
  test::expectInputError([&] { waitBefore("Set do1; WaitTime -1;", ""); }, "a wait must not be negative");
}

TEST(RapidReader, RefusesWhatItCannotFollow) {
  const std::pair<std::string, std::string> cases[] = {
      {inMain("MoveC " + target + "," + target + ",v100,fine,tool0;"), "instruction 'movec' is not read"},
      {inMain("FOR i FROM 1 TO 3 DO " + move + " ENDFOR"), "line 4: 'for' is not read"},
      {inMain("IF x THEN " + move + " ENDIF"), "under a condition"},
      {inMain("IF x THEN main; ENDIF"), "under a condition"},
      {inMain("IF x " + move), "IF without ENDIF"},
      {inMain("VelSet 50,800;" + move), "instruction 'velset' is not read"},
      {inMain("main;"), "too deeply"},
      {inMain("MoveL p1,v100,fine,tool0;"), "'p1' is not declared"},
      {inMain("p:=x;MoveL p,v100,fine,tool0;", "VAR robtarget p:=" + target + ";"), "at run time"},
      {inMain("MoveL p,v100,fine,tool0;", "VAR robtarget p;"), "has no value"},
      {inMain("MoveL p,v100,fine,tool0;", "CONST robtarget p:=p;"), "refers to itself"},
      {inMain("MoveL " + target + ",v99,fine,tool0;"), "'v99' is not declared"},
      {inMain("MoveL " + target + ",v100,fine,tool0\\Corr;"), "\\corr is not read"},
      {inMain("MoveL " + target + ",v100,fine;"), "needs point, speed, zone and tool"},
      {inMain("MoveL [[1,2,3],[1,0.01,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;"), "length 1"},
      {inMain("MoveL [[1,2],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;"), "3 components"},
      {inMain("MoveL [[1,2,1E400],[1,0,0,0],[0,0,0,0],[]],v100,fine,tool0;"), "out of range"},
      {inMain("MoveL [[1,2,1E300*1E300],[1,0,0,0],[0,0,0,0],[]],v100,fine,tool0;"), "not finite"},
      {inMain("MoveL [[1,2,1/0],[1,0,0,0],[0,0,0,0],[]],v100,fine,tool0;"), "not finite"},
      {inMain(move, "CONST num a:=1;CONST num A:=2;"), "declared twice"},
      {inMain(move, "CONST num a{3}:=[1,2,3];"), "arrays are not read"},
      {"MODULE M\nENDMODULE", "no routine main"},
      {"MODULE M\nPROC main()\n", "line 3: expected a name, found ''"},
      {"MODULE M\nFUNC num f()\n", "ends too early"},
      {"", "expected module"},
      {inMain(move) + "x", "after ENDMODULE"},
      {inMain("TPWrite \"abc"), "string has no end"},
      {inMain("MoveL \xc3\xa4;"), "has no meaning"},
  };
  for (const auto& [text, message] : cases) {
    test::expectInputError([&t = text] { readRapid({{"m.mod", t}}); }, message);
  }
  test::expectInputError([] { readRapid({{"m.mod", inMain(move)}, {"n.mod", inMain(move)}}); }, "another module");
  test::expectInputError([] { readRapid({}); }, "no routine main");
}

// A few lines may ask for 2^40 moves or values: the reader gives up in bounded time.
TEST(RapidReader, GivesUpOnExplosiveText) {
  std::string routines = inMain("p0;");
  routines.resize(routines.find("ENDMODULE"));
  std::string data = "CONST num d0:=1;";
  for (int i = 0; i < 40; ++i) {
    const std::string next = std::to_string(i + 1);
    routines += "PROC p" + std::to_string(i) + "()\np" + next + ";p" + next + ";\nENDPROC\n";
    data += "CONST num d" + next + ":=[d" + std::to_string(i) + ",d" + std::to_string(i) + "];";
  }
  routines += "PROC p40()\nWaitTime 0;\nENDPROC\nENDMODULE";
  RapidReadOptions options;
  options.max_steps = 100000;
  test::expectInputError([&] { readRapid({{"m.mod", routines}}, options); }, "too long");
  test::expectInputError([&] { readRapid({{"m.mod", inMain("MoveL d40,v100,fine,tool0;", data)}}); }, "too large");
  const std::string deep = std::string(100000, '(') + "1" + std::string(100000, ')');
  test::expectInputError([&] { readRapid({{"m.mod", inMain("WaitTime " + deep + ";")}}); }, "too deeply");
  test::expectInputError(
      [&] {
        readRapid({{"m.mod", inMain("WaitTime " + std::string(100000, '-') + "1;")}});
      },
      "too deeply");
}

// Bytes and words of valid programs changed at random: an InputError or a program, nothing else.
TEST(RapidReader, SurvivesSeededMutations) {
  const auto file = std::string(SCAN_TO_PATH_SOURCE_DIR) + "/tests/program/fixtures/hand_written.mod";
  const std::string texts[] = {readFile(file), writeProgram(Controller::abb, test::seededInput(1, 1, 5)).at(1).content};
  const char* words[] = {"MoveL", "[",     "]", ":=", "PROC", "ENDPROC", "9E9", "\"",
                         "IF",    "ENDIF", ";", "(",  "-",    "/0",      "!"};
  Random random(11);
  int read = 0;
  for (int round = 0; round < 4000; ++round) {
    std::string text = texts[round % 2];
    for (int change = 0; change <= round % 4; ++change) {
      const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(text.size()));
      const auto length = static_cast<std::size_t>(random.uniform(0, 12));
      switch (random.bits() % 4) {
        case 0:
          text[at] = static_cast<char>(random.bits());
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(at, words[random.bits() % std::size(words)]);
          break;
        default:
          text.insert(at, text.substr(random.bits() % text.size(), length));
          break;
      }
    }
    try {
      for (const auto& found : readRapid({{"m.mod", text}}).moves) {
        ASSERT_TRUE(found.T_base_tcp.matrix().allFinite());
      }
      ++read;
    } catch (const InputError& error) {
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(read, 100);
}

}  // namespace
}  // namespace scan_to_path::program
