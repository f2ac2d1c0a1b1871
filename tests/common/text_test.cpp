// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/text.h"

#include <gmock/gmock.h>

#include <cfloat>
#include <cmath>
#include <cstdio>

#include "scan_to_path/common/output_directory.h"
#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path {
namespace {

using ::testing::ElementsAre;

TEST(Text, FixedNumbersHaveTheDigitsAskedForAndNoNegativeZero) {
  EXPECT_EQ(fixed(3.14159, 2), "3.14");
  EXPECT_EQ(fixed(-1.5, 0), "-2");
  EXPECT_EQ(fixed(2.5, 0), "2");
  EXPECT_EQ(fixed(-0.0, 3), "0.000");
  EXPECT_EQ(fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-0.0005001, 3), "-0.001");
  EXPECT_EQ(fixed(1e-300, 1), "0.0");
}

TEST(Text, FixedNumbersAgreeWithPrintf) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double value = random.gaussian() * std::pow(10.0, random.uniform(-8, 12));
    const int digits = i % 10;
    char expected[64];
    std::snprintf(expected, sizeof(expected), "%.*f", digits, value);
    if (std::string(expected).find_first_not_of("-0.") == std::string::npos) continue;
    EXPECT_EQ(fixed(value, digits), expected);
  }
}

TEST(Text, FixedNumbersHaveRoomForTheLargest) {
  EXPECT_EQ(fixed(-DBL_MAX, 6).size(), 1U + 309U + 1U + 6U);
  EXPECT_EQ(fixed(INFINITY, 2), "inf");
  EXPECT_EQ(fixed(NAN, 2), "nan");
}

TEST(Text, AppendingKeepsWhatIsThere) {
  std::string text = "x=";
  appendFixed(text, 1.25, 1);
  text += ',';
  appendInteger(text, -9223372036854775807LL - 1);
  EXPECT_EQ(text, "x=1.2,-9223372036854775808");
}

TEST(Text, ParseNumberTakesAllOrNothing) {
  double value = 0.0;
  const std::vector<std::pair<const char*, double>> good = {
      {"1", 1.0}, {"+2.5", 2.5}, {"-1e-3", -1e-3}, {".5", 0.5}, {"5.", 5.0}};
  for (const auto& [text, expected] : good) {
    EXPECT_TRUE(parseNumber(text, value)) << text;
    EXPECT_EQ(value, expected);
  }
  for (const char* text : {"", "+", "-", " 1", "1 ", "1,5", "0x10", "1e", "1e999", "one", "+-1", "--1"}) {
    EXPECT_FALSE(parseNumber(text, value)) << "'" << text << "'";
  }
  EXPECT_TRUE(parseNumber("nan", value) && std::isnan(value));
  EXPECT_TRUE(parseNumber("-inf", value) && value == -INFINITY);
}

TEST(Text, FixedNumbersReadBackWithinHalfADigit) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.uniform(-10, 10);
    double back = 0.0;
    ASSERT_TRUE(parseNumber(fixed(value, 9), back));
    EXPECT_NEAR(back, value, 0.5000001e-9);
  }
}

TEST(Text, TrimmedAndSplit) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed(" \r\n"), "");
  EXPECT_EQ(trimmed(""), "");
  EXPECT_THAT(split("a,,b,", ','), ElementsAre("a", "", "b", ""));
  EXPECT_THAT(split("", ','), ElementsAre(""));
}

TEST(Text, NearestWordHelpsWithSpelling) {
  const std::vector<std::string> words = {"scallop_height", "ball_radius", "feed"};
  EXPECT_EQ(nearestWord("scalop_height", words), "scallop_height");
  EXPECT_EQ(nearestWord("radius", words), "ball_radius");
  EXPECT_EQ(nearestWord("fee", words), "feed");
  EXPECT_EQ(nearestWord("", words), "feed");
  EXPECT_EQ(nearestWord("x", {}), "");
  EXPECT_EQ(nearestWord("ab", {"ax", "xb"}), "ax");  // the first of equals
}

TEST(Text, Sha256HasItsPublishedValues) {
  // FIPS 180-4 examples.
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Text, ReadFileGivesAllBytes) {
  const std::string path = ::testing::TempDir() + "read_file_test";
  std::string content(200000, 'x');
  content[100] = '\0';
  content[70000] = '\n';
  writeFileAtomically(path, content);
  EXPECT_EQ(readFile(path), content);
  writeFileAtomically(path, "");
  EXPECT_EQ(readFile(path), "");
  std::remove(path.c_str());
  test::expectInputError([&] { readFile(path); }, "cannot read " + path + ": No such file or directory");
  test::expectInputError([] { readFile("/tmp"); }, "cannot read /tmp: is a directory");
}

}  // namespace
}  // namespace scan_to_path
