// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/decimal.h"

#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "scan_to_path/common/random.h"

namespace scan_to_path::scan {
namespace {

/// Value and number of characters read; -1 where it refuses.
std::pair<double, std::ptrdiff_t> parsed(const std::string& text) {
  double value = 0.0;
  const char* const end = parseDecimal(text.data(), text.data() + text.size(), value);
  return {value, end == nullptr ? -1 : end - text.data()};
}

std::string randomDigits(Random& random, std::size_t count) {
  std::string digits;
  for (std::size_t k = 0; k < count; ++k) digits += static_cast<char>('0' + random.bits() % 10);
  return digits;
}

TEST(ParseDecimal, IsRoundedAsTheCLibraryRounds) {
  Random random(1);
  for (int round = 0; round < 100000; ++round) {
    const std::size_t whole = random.bits() % 11;
    const std::size_t fraction = random.bits() % (16 - whole);
    std::string text = (random.uniform() < 0.5 ? "-" : "") + randomDigits(random, whole);
    if (fraction > 0) text += "." + randomDigits(random, fraction);
    if (whole + fraction == 0) continue;
    const auto [value, length] = parsed(text);
    ASSERT_EQ(length, static_cast<std::ptrdiff_t>(text.size())) << text;
    ASSERT_EQ(value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ParseDecimal, StopsBehindTheNumber) {
  EXPECT_EQ(parsed("12.50,7"), std::make_pair(12.5, std::ptrdiff_t{5}));
  EXPECT_EQ(parsed("-3 "), std::make_pair(-3.0, std::ptrdiff_t{2}));
  EXPECT_EQ(parsed("4."), std::make_pair(4.0, std::ptrdiff_t{2}));
  EXPECT_EQ(parsed(".25e3"), std::make_pair(0.25, std::ptrdiff_t{3}));  // the caller sees the exponent
  EXPECT_TRUE(std::signbit(parsed("-0").first));
}

TEST(ParseDecimal, RefusesWhatIsNotPlainOrTooLong) {
  for (const char* text :
       {"", "-", ".", "-.", "+1", " 1", "nan", "inf", "1234567890123456", "0.000000000000001", "--1"}) {
    EXPECT_EQ(parsed(text).second, -1) << text;
  }
  EXPECT_EQ(parsed("123456789012345").second, 15);
}

TEST(AppendDecimal, WritesWhatTheCLibraryWrites) {
  Random random(2);
  for (int round = 0; round < 100000; ++round) {
    const int digits = static_cast<int>(random.bits() % 7);
    const double value = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-7.0, 8.0));
    // Up to 1e14 ticks: a product is rounded to 1/128 of a tick, so nearly half way between two either may be taken.
    const double ticks = std::abs(value) * std::pow(10.0, digits);
    if (std::abs(ticks - std::floor(ticks) - 0.5) < 0.03) continue;
    std::string text;
    appendDecimal(text, value, digits);
    char expected[64];
    std::snprintf(expected, sizeof expected, "%.*f", digits, value);
    // "-0.00" is written without its sign.
    if (std::strspn(expected, "-0.") == std::strlen(expected) && expected[0] == '-') {
      ASSERT_EQ(text, expected + 1);
    } else {
      ASSERT_EQ(text, expected);
    }
  }
}

TEST(AppendDecimal, LargeValuesAndNotANumber) {
  const auto written = [](double value, int digits) {
    std::string text = "x";
    appendDecimal(text, value, digits);
    return text;
  };
  EXPECT_EQ(written(std::nan(""), 3), "xnan");
  EXPECT_EQ(written(1e25, 1), "x10000000000000000905969664.0");
  EXPECT_EQ(written(2.5, 0), "x3");  // halves away from zero
  EXPECT_EQ(written(-2.5, 0), "x-3");
  EXPECT_EQ(written(0.9999999, 6), "x1.000000");
}

TEST(AppendTicks, HasAllDigitsAndBothEnds) {
  const auto written = [](std::int64_t ticks, int digits) {
    std::string text;
    appendTicks(text, ticks, digits);
    return text;
  };
  EXPECT_EQ(written(-1500, 3), "-1.500");
  EXPECT_EQ(written(7, 6), "0.000007");
  EXPECT_EQ(written(0, 0), "0");
  EXPECT_EQ(written(INT64_MIN, 6), "-9223372036854.775808");
  EXPECT_EQ(written(INT64_MAX, 0), "9223372036854775807");
}

TEST(AppendShortest, DropsOnlyZerosBehindThePoint) {
  const auto written = [](double value) {
    std::string text = "1.50,";
    appendShortest(text, value, 3);
    return text.substr(5);
  };
  EXPECT_EQ(written(1200.0), "1200");
  EXPECT_EQ(written(-0.25), "-0.25");
  EXPECT_EQ(written(0.0004), "0");
  EXPECT_EQ(written(std::nan("")), "nan");
}

}  // namespace
}  // namespace scan_to_path::scan
