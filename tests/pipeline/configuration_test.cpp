// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/configuration.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "scan_to_path/common/random.h"

namespace scan_to_path {
namespace {

enum class Colour { red, dark_green };

struct Inner {
  double length = 0.25;
  Eigen::Vector3d axis = Eigen::Vector3d(0.0, 0.0, 1.0);

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.length, Field{"length", "m", "how long", 0.0, 2.0});
    visit(self.axis, Field{"axis", "", "which way", -1.0, 1.0});
  }
};

struct Outer {
  int count = 3;
  bool on = false;
  std::string name = "first one";
  Colour colour = Colour::red;
  std::vector<double> gains = {1.0, 0.1};
  std::vector<std::string> words = {"a", "b c"};
  std::vector<Eigen::Vector2d> corners;
  std::optional<double> known;
  Inner inner;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.count, Field{"count", "", "how many", 1.0, 10.0});
    visit(self.on, Field{"on"});
    visit(self.name, Field{"name"});
    visit(self.colour, Field{"colour", "", "paint"});
    visit(self.gains, Field{"gains", "1/s"});
    visit(self.words, Field{"words"});
    visit(self.corners, Field{"corners", "m", "of something", -5.0, 5.0});
    visit(self.known, Field{"known", "s", "if it is", -1.0, 1.0});
    visit(self.inner, Field{"inner"});
  }
};

}  // namespace

template <>
struct EnumNames<Colour> {
  static constexpr std::array<const char*, 2> names = {"red", "dark_green"};
};

namespace pipeline {
namespace {

using ::testing::HasSubstr;

std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string yamlError(const std::string& text) {
  Outer outer;
  return errorOf([&] { applyYaml(fieldReferences(outer), text, "cell.yaml"); });
}

TEST(Configuration, ListsLeavesInDeclaredOrder) {
  Outer outer;
  std::vector<std::string> paths;
  for (const auto& field : fieldReferences(outer)) paths.push_back(field.path);
  EXPECT_THAT(paths, ::testing::ElementsAre("count", "on", "name", "colour", "gains", "words", "corners", "known",
                                            "inner.length", "inner.axis"));
}

TEST(Configuration, AppliesEveryType) {
  Outer outer;
  applyYaml(fieldReferences(outer),
            "count: 7\non: true\nname: 'x: y'\ncolour: dark_green\ngains: [3, 4e-3]\nwords: [p]\ncorners: [[1, 2], "
            "[-3, 0.25]]\nknown: 0\n"
            "inner:\n  length: 1.5\n  axis: [1, 0, 0.5]\n",
            "t");
  EXPECT_EQ(outer.count, 7);
  EXPECT_TRUE(outer.on);
  EXPECT_EQ(outer.name, "x: y");
  EXPECT_EQ(outer.colour, Colour::dark_green);
  EXPECT_EQ(outer.gains, (std::vector<double>{3.0, 4e-3}));
  EXPECT_EQ(outer.words, std::vector<std::string>{"p"});
  EXPECT_EQ(outer.corners, (std::vector<Eigen::Vector2d>{{1.0, 2.0}, {-3.0, 0.25}}));
  EXPECT_EQ(outer.known, 0.0);
  EXPECT_EQ(outer.inner.length, 1.5);
  EXPECT_EQ(outer.inner.axis, Eigen::Vector3d(1.0, 0.0, 0.5));
}

TEST(Configuration, EmptyTextAndEmptySectionChangeNothing) {
  Outer outer;
  applyYaml(fieldReferences(outer), "", "t");
  applyYaml(fieldReferences(outer), "inner:\n", "t");
  EXPECT_EQ(outer.inner.length, Inner().length);
}

TEST(Configuration, TellsWhatWasSetBeItTheDefault) {
  Outer outer;
  const auto fields = fieldReferences(outer);
  EXPECT_THAT(applyYaml(fields, "count: 3\ninner:\n  length: 0.25\n", "t"),
              ::testing::UnorderedElementsAre("count", "inner.length"));
  EXPECT_TRUE(applyYaml(fields, "inner:\n", "t").empty());
  EXPECT_EQ(applyAssignment(fields, " inner.axis =[0, 0, 1]"), "inner.axis");
}

// A number that nobody gave is another thing than 0.
TEST(Configuration, NumbersMayBeUnset) {
  Outer outer;
  const auto fields = fieldReferences(outer);
  EXPECT_THAT(formatYaml(fields), HasSubstr("known: unset  # [s] if it is\n"));
  applyAssignment(fields, "known=0");
  EXPECT_EQ(outer.known, 0.0);
  EXPECT_THAT(formatYaml(fields), HasSubstr("known: 0  # [s] if it is\n"));
  applyAssignment(fields, "known=unset");
  EXPECT_FALSE(outer.known.has_value());
  EXPECT_NO_THROW(validate(outer, ""));
  outer.known = 2.0;
  EXPECT_EQ(errorOf([&] { validate(outer, ""); }), "known is 2 s, must be in [-1, 1]");
}

TEST(Configuration, NamesTheNearestKey) {
  EXPECT_THAT(yamlError("inner:\n  lenght: 1\n"), HasSubstr("cell.yaml line 2: unknown key inner.lenght"));
  EXPECT_THAT(yamlError("inner:\n  lenght: 1\n"), HasSubstr("did you mean inner.length?"));
  EXPECT_THAT(yamlError("iner: {}\n"), HasSubstr("did you mean inner?"));
}

TEST(Configuration, RejectsWrongTypes) {
  EXPECT_EQ(yamlError("count: 1.5"), "cell.yaml line 1: count is '1.5', must be a whole number");
  EXPECT_EQ(yamlError("on: maybe"), "cell.yaml line 1: on is 'maybe', must be true or false");
  EXPECT_EQ(yamlError("gains: 3"), "cell.yaml line 1: gains is '3', must be a list of numbers");
  EXPECT_EQ(yamlError("corners: [[1, 2], [3]]"), "cell.yaml line 1: corners is a list of 2, must be a list of [x, y]");
  EXPECT_EQ(yamlError("corners: 3"), "cell.yaml line 1: corners is '3', must be a list of [x, y]");
  EXPECT_EQ(yamlError("corners: [[1, x]]"), "cell.yaml line 1: corners is a list of 1, must be a number [m]");
  EXPECT_EQ(yamlError("\ninner: {length: wide}"), "cell.yaml line 2: inner.length is 'wide', must be a number [m]");
  EXPECT_EQ(yamlError("inner: {axis: [1, 2]}"),
            "cell.yaml line 1: inner.axis is a list of 2, must be a list of 3 numbers");
  EXPECT_EQ(yamlError("known: no"), "cell.yaml line 1: known is 'no', must be a number [s] or unset");
  EXPECT_EQ(yamlError("known:"), "cell.yaml line 1: known is empty, must be a number [s] or unset");
  EXPECT_EQ(yamlError("colour: blue"), "cell.yaml line 1: colour is 'blue', must be one of red, dark_green");
  EXPECT_EQ(yamlError("inner: 3"), "cell.yaml line 1: inner is '3', must be a section");
  EXPECT_EQ(yamlError("count: 1\ncount: 2"), "cell.yaml line 2: key count stands twice");
  EXPECT_THAT(yamlError("- a\n- b"), HasSubstr("a configuration is sections of keys"));
  EXPECT_THAT(yamlError("count: [1, 2"), HasSubstr("not YAML"));
}

// A broken file must neither reach the terminal with its bytes nor fill it.
TEST(Configuration, BytesOfAFileAreEscaped) {
  EXPECT_THAT(yamlError("\x1b[2J: 1"), HasSubstr("cell.yaml line 1: unknown key \\x1b[2J, did you mean "));
  EXPECT_THAT(yamlError("count: \"\\e[31m\""), HasSubstr("count is '\\x1b[31m', must be a number"));
  EXPECT_THAT(yamlError("\"co\\0unt\": 1"), HasSubstr("unknown key co\\x00unt, did you mean count?"));
  EXPECT_THAT(yamlError("\"\\a\": 1\n\"\\a\": 2"), HasSubstr("\\x07"));
  const std::string long_key(100000, 'k');
  EXPECT_LT(yamlError(long_key + ": 1").size(), 200U);
  EXPECT_LT(yamlError("count: " + long_key).size(), 200U);
  EXPECT_LT(yamlError(long_key).size(), 200U);
}

// Random bytes, some of them after a good beginning: one short line that every terminal can show.
TEST(Configuration, GarbageGivesOnePrintableLine) {
  Random random(5);
  int refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = round % 2 == 0 ? "" : "count: 3\ninner:\n  length: ";
    for (int i = 0; i < 1 + round % 60; ++i) text += static_cast<char>(random.bits());
    const std::string error = yamlError(text);
    refused += error == "no error" ? 0 : 1;
    ASSERT_LT(error.size(), 600U);
    ASSERT_TRUE(std::all_of(error.begin(), error.end(), [](char c) { return c >= ' ' && c <= '~'; })) << round;
  }
  EXPECT_GT(refused, 1500);
}

TEST(Configuration, OneDocumentOnly) {
  EXPECT_EQ(yamlError("count: 4\n---\non: true\n"), "cell.yaml line 2: begins another document, must be one");
  EXPECT_EQ(yamlError("---\n--- # again\ncount: 4\n"), "cell.yaml line 2: begins another document, must be one");
  EXPECT_EQ(yamlError("# ours\n%YAML 1.2\n---\ncount: 4\nname: a---b\nwords:\n- --- x\n"), "no error");
}

TEST(Configuration, KeysThatStandTwiceAreNamedInEverySection) {
  EXPECT_EQ(yamlError("inner: {length: 1}\ncount: 1\ninner: {length: 2}"), "cell.yaml line 3: key inner stands twice");
  EXPECT_EQ(yamlError("inner:\n  length: 1\n  length: 1\n"), "cell.yaml line 3: key inner.length stands twice");
}

TEST(Configuration, AFileThatSetsNothingIsRefused) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "sets_nothing.yaml";
  Outer outer;
  const auto fields = fieldReferences(outer);
  const auto error = [&](const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
    return errorOf([&] { applyYamlFile(fields, file); });
  };
  for (const std::string text : {"", "\n \n", "# count: 3\n", "inner:\n", "{}", "~", "\xff\xfe"}) {
    EXPECT_THAT(error(text), HasSubstr("sets_nothing.yaml: sets nothing")) << text;
  }
  EXPECT_THAT(error("7"), HasSubstr("sets_nothing.yaml: a configuration is sections of keys, this is '7'"));
  EXPECT_THAT(error("[a, b]"),
              HasSubstr("sets_nothing.yaml: a configuration is sections of keys, this is a list of 2"));
  EXPECT_EQ(error("count: 4"), "no error");
  EXPECT_EQ(outer.count, 4);
  std::filesystem::remove(file);
  EXPECT_THAT(errorOf([&] { applyYamlFile(fields, file); }), HasSubstr("cannot read"));
  EXPECT_THAT(errorOf([&] { applyConfiguration(fields, "# count: 3\n", "a pipe"); }),
              HasSubstr("a pipe: sets nothing"));
}

TEST(Configuration, AssignmentsSetOneField) {
  Outer outer;
  const auto fields = fieldReferences(outer);
  applyAssignment(fields, "inner.axis=[0, 1, 0]");
  applyAssignment(fields, "name = a: b");
  applyAssignment(fields, "colour=dark_green");
  EXPECT_EQ(outer.inner.axis, Eigen::Vector3d(0.0, 1.0, 0.0));
  EXPECT_EQ(outer.name, "a: b");
  EXPECT_EQ(outer.colour, Colour::dark_green);
  EXPECT_THAT(errorOf([&] { applyAssignment(fields, "inner.size=3"); }), HasSubstr("unknown key inner.size"));
  EXPECT_THAT(errorOf([&] { applyAssignment(fields, "inner.length"); }), HasSubstr("must be section.name=value"));
}

TEST(Configuration, AssignmentsThatAreNoneSayWhatTheyAre) {
  Outer outer;
  const auto fields = fieldReferences(outer);
  const auto error = [&](const std::string& assignment) {
    return errorOf([&] { applyAssignment(fields, assignment); });
  };
  EXPECT_EQ(error("inner=3"), "--set inner: is a section; set one of its values, such as inner.length");
  EXPECT_EQ(error("inn=3"), "--set: unknown key inn, did you mean inner?");
  EXPECT_EQ(error("=1"), "--set '=1': must be section.name=value");
  EXPECT_EQ(error(" =1"), "--set ' =1': must be section.name=value");
  EXPECT_EQ(error("count=many"), "--set count is 'many', must be a number");
  EXPECT_EQ(error("inner.length="), "--set inner.length is empty, must be a number [m]");
  EXPECT_EQ(error("inner.axis=[1, 2]"), "--set inner.axis is a list of 2, must be a list of 3 numbers");
  EXPECT_THAT(error("count=[1"), ::testing::StartsWith("--set count: not YAML: "));
  EXPECT_EQ(error("count=1\n---\n2"), "--set count: begins another document, must be one");
}

TEST(Configuration, RoundTripKeepsEveryBit) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    Outer written;
    written.count = static_cast<int>(random.uniform(1.0, 10.0));
    written.on = random.uniform() < 0.5;
    written.name = random.uniform() < 0.5 ? "true \"\\ #: 1" : "";
    written.colour = random.uniform() < 0.5 ? Colour::red : Colour::dark_green;
    written.gains = {random.gaussian() * 1e-9, random.gaussian() * 1e9};
    for (int i = 0; i < round % 3; ++i) written.corners.emplace_back(random.gaussian(), random.gaussian());
    written.inner.length = random.uniform();
    written.inner.axis = Eigen::Vector3d(random.gaussian(), random.gaussian(), random.gaussian());
    const std::string text = formatYaml(fieldReferences(written));
    Outer read;
    applyYaml(fieldReferences(read), text, "t");
    EXPECT_EQ(formatYaml(fieldReferences(read)), text);
    EXPECT_EQ(read.inner.axis, written.inner.axis);
    EXPECT_EQ(read.corners, written.corners);
    EXPECT_EQ(read.name, written.name);
  }
}

TEST(Configuration, FormatShowsUnitHelpAndChoices) {
  Outer outer;
  const std::string text = formatYaml(fieldReferences(outer));
  EXPECT_THAT(text, HasSubstr("\n  length: 0.25  # [m] how long\n"));
  EXPECT_THAT(text, HasSubstr("colour: red  # paint: red | dark_green\n"));
}

TEST(Configuration, ValidationNamesPathValueAndRange) {
  Outer outer;
  outer.inner.length = 3.0;
  EXPECT_EQ(errorOf([&] { validate(outer, ""); }), "inner.length is 3 m, must be in [0, 2]");
  outer.inner.length = std::nan("");
  EXPECT_EQ(errorOf([&] { validate(outer, ""); }), "inner.length is nan m, must be in [0, 2]");
  outer.inner.length = 1.0;
  outer.gains[1] = INFINITY;
  EXPECT_EQ(errorOf([&] { validate(outer, ""); }), "gains[1] is inf 1/s, must be finite");
  outer.gains[1] = 1.0;
  outer.inner.axis.y() = 1.5;
  EXPECT_EQ(errorOf([&] { validate(outer, "x"); }), "x.inner.axis[1] is 1.5, must be in [-1, 1]");
}

}  // namespace
}  // namespace pipeline
}  // namespace scan_to_path
