// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/lzf.h"

#include <gmock/gmock.h>

#include "scan_to_path/common/random.h"

namespace scan_to_path::scan {
namespace {

/// Packs greedily: the longest of the copies from up to 8192 bytes before, else a literal byte. Independent of
/// the expander but for the format.
std::string packLzf(const std::string& data) {
  std::string packed;
  std::string literals;
  const auto flush = [&] {
    for (std::size_t at = 0; at < literals.size(); at += 32) {
      const std::string run = literals.substr(at, 32);
      packed += static_cast<char>(run.size() - 1);
      packed += run;
    }
    literals.clear();
  };
  std::size_t at = 0;
  while (at < data.size()) {
    std::size_t longest = 0, back = 0;
    for (std::size_t distance = 1; distance <= std::min<std::size_t>(at, 8192); ++distance) {
      std::size_t length = 0;
      while (length < 264 && at + length < data.size() && data[at + length] == data[at + length - distance]) ++length;
      if (length > longest) longest = length, back = distance;
    }
    if (longest < 3) {
      literals += data[at++];
      continue;
    }
    flush();
    const std::size_t code = longest - 2, offset = back - 1;
    packed += static_cast<char>((std::min<std::size_t>(code, 7) << 5) | (offset >> 8));
    if (code >= 7) packed += static_cast<char>(code - 7);
    packed += static_cast<char>(offset & 255);
    at += longest;
  }
  flush();
  return packed;
}

/// Bytes of which each goes on with a stretch seen before or is new.
std::string repetitive(Random& random, std::size_t size) {
  std::string data;
  while (data.size() < size) {
    if (!data.empty() && random.uniform() < 0.3) {
      const std::size_t from = random.bits() % data.size();
      const std::size_t length = random.bits() % 400;
      for (std::size_t k = 0; k < length; ++k) data += data[from + k];
    } else {
      data += static_cast<char>(random.bits());
    }
  }
  data.resize(size);
  return data;
}

TEST(Lzf, CopiesBackReferences) {
  // "abc", then 9 bytes from 3 before (over itself), then 20 from 12 before in the long form.
  const std::string packed =
      std::string("\x02") + "abc" + std::string("\xe0\x00\x02", 3) + std::string("\xe0\x0b\x0b", 3);
  EXPECT_EQ(expandLzf(packed, 32).value_or(""), "abcabcabcabcabcabcabcabcabcabcab");
  EXPECT_FALSE(expandLzf(packed, 31));
  EXPECT_FALSE(expandLzf(packed, 33));
  EXPECT_FALSE(expandLzf(std::string("\x20\x05", 2), 3));  // refers to before the start
  EXPECT_FALSE(expandLzf("", std::size_t{1} << 40));
  EXPECT_FALSE(expandLzf(std::string("\x05"
                                     "ab"),
                         6));
}

TEST(Lzf, ExpandsWhatAnIndependentPackerPacked) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const std::string data = repetitive(random, 1 + random.bits() % 12000);
    const std::string packed = packLzf(data);
    EXPECT_TRUE(expandLzf(packed, data.size()) == data) << "seed " << seed;
    EXPECT_FALSE(expandLzf(packed, data.size() + 1)) << "seed " << seed;
    EXPECT_FALSE(expandLzf(packed.substr(0, packed.size() - 1), data.size())) << "seed " << seed;
  }
}

TEST(Lzf, TheFarthestAndLongestCopyIsReached) {
  Random random(1);
  std::string data;
  for (int i = 0; i < 8192; ++i) data += static_cast<char>(random.bits());
  data += data.substr(0, 264);  // from 8192 before: the format's limits
  const std::string packed = packLzf(data);
  EXPECT_EQ(packed.substr(packed.size() - 3), std::string("\xff\xff\xff", 3));
  EXPECT_TRUE(expandLzf(packed, data.size()) == data);
}

TEST(Lzf, NothingMeansNothing) {
  EXPECT_EQ(expandLzf("", 0).value_or("x"), "");
  EXPECT_FALSE(expandLzf("", 1));
}

TEST(Lzf, DamagedDataIsRefusedOrExpandedToItsSize) {
  Random random(3);
  const std::string data = repetitive(random, 2000);
  const std::string packed = packLzf(data);
  int refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string damaged = packed.substr(0, 1 + random.bits() % packed.size());
    damaged[random.bits() % damaged.size()] = static_cast<char>(random.bits());
    const auto expanded = expandLzf(damaged, data.size());
    refused += expanded ? 0 : 1;
    if (expanded) {
      EXPECT_EQ(expanded->size(), data.size());
    }
  }
  EXPECT_GT(refused, 1900);
}

}  // namespace
}  // namespace scan_to_path::scan
