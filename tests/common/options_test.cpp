// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/expect_input_error.h"

namespace scan_to_path {

enum class Colour { red, green };

template <>
struct EnumNames<Colour> {
  static constexpr std::array<const char*, 2> names = {"red", "green"};
};

namespace {

using test::expectInputError;

struct Inner {
  double radius = 0.02;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.radius, Field{"radius", "m", "of the ball", 1e-4, 0.5});
  }
};

struct Lists {
  std::vector<double> feeds = {0.1, 0.2};
  std::vector<Eigen::Vector2d> corners = {{0.0, 1.0}};
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.feeds, Field{"feeds", "m/s", "one per pass", 0.0, 1.0});
    visit(self.corners, Field{"corners", "m", "", -1.0, 1.0});
  }
};

struct Outer {
  int count = 3;
  bool is_on = true;
  double free = 0.0;
  std::string name = "x";
  Colour colour = Colour::green;
  Inner inner;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.count, Field{"count", "", "how many", 1, 10});
    visit(self.is_on, Field{"is_on"});
    visit(self.free, Field{"free"});
    visit(self.name, Field{"name"});
    visit(self.colour, Field{"colour"});
    visit(self.inner, Field{"inner"});
  }
};

TEST(Options, DefaultsAreValid) { EXPECT_NO_THROW(validate(Outer{}, "o")); }

TEST(Options, RangesIncludeTheirEnds) {
  Outer options;
  options.count = 10;
  options.inner.radius = 1e-4;
  EXPECT_NO_THROW(validate(options, "o"));
}

TEST(Options, MessageNamesPathValueUnitAndRange) {
  Outer options;
  options.count = 11;
  expectInputError([&] { validate(options, "path"); }, "path.count is 11, must be in [1, 10]");
  options.count = 1;
  options.inner.radius = 0.6;
  expectInputError([&] { validate(options, "path"); }, "path.inner.radius is 0.6 m, must be in [0.0001, 0.5]");
}

TEST(Options, NumbersMustBeFiniteEvenWithoutARange) {
  Outer options;
  options.free = std::nan("");
  expectInputError([&] { validate(options, "o"); }, "o.free is nan, must be finite");
  options.free = -INFINITY;
  expectInputError([&] { validate(options, "o"); }, "o.free is -inf, must be finite");
  options.free = 0.0;
  options.inner.radius = std::nan("");
  expectInputError([&] { validate(options, "o"); }, "o.inner.radius is nan m, must be in [0.0001, 0.5]");
}

TEST(Options, RangesHoldForEveryElementOfAList) {
  Lists options;
  EXPECT_NO_THROW(validate(options, "o"));
  options.feeds[1] = 2.0;
  expectInputError([&] { validate(options, "o"); }, "o.feeds[1] is 2 m/s, must be in [0, 1]");
  options.feeds[1] = 1.0;
  options.corners.emplace_back(0.5, std::nan(""));
  expectInputError([&] { validate(options, "o"); }, "o.corners[1][1] is nan m, must be in [-1, 1]");
}

TEST(Options, OptionStructsAreToldFromOtherTypes) {
  EXPECT_TRUE(IsOptions<Outer>::value);
  EXPECT_FALSE(IsOptions<int>::value);
  EXPECT_FALSE(IsOptions<std::string>::value);
}

TEST(Options, FieldsCanBeSetThroughTheList) {
  Outer options;
  Outer::fields(options, [](auto& value, const Field& field) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, int>) {
      if (std::string(field.name) == "count") value = 7;
    }
  });
  EXPECT_EQ(options.count, 7);
}

TEST(Options, EnumsHaveNames) { EXPECT_STREQ(enumName(Colour::green), "green"); }

}  // namespace
}  // namespace scan_to_path
