// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "mutate.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace scan_to_path::fuzz {
namespace {

using namespace std::string_view_literals;

constexpr std::array words = {"nan"sv, "inf"sv, "-inf"sv, "-1"sv, "0"sv, "4294967295"sv, "1e999"sv, "1e-999"sv,
                              "-0"sv,  "9"sv,   "1e18"sv, "."sv,  "-"sv, "0x10"sv,       "\n"sv,    "\r\n"sv,
                              " "sv,   "\t"sv,  ","sv,    "#"sv,  "/"sv, "\""sv,         "\0"sv,    "\xff"sv};

/// Little-endian words that break sums and products: large counts, signs, NaN and infinity as floats.
constexpr std::array patterns = {"\xff\xff\xff\xff"sv, "\x00\x00\x00\x80"sv, "\xff\xff\xff\x7f"sv,
                                 "\x00\x00\x00\x00"sv, "\x00\x00\xc0\x7f"sv, "\x00\x00\x80\x7f"sv,
                                 "\x01\x00\x00\x00"sv, "\x00\x00\x00\x40"sv};

std::size_t below(Random& random, std::size_t limit) { return limit == 0 ? 0 : random.bits() % limit; }

/// Short pieces mostly, long ones now and then.
std::size_t pieceLength(Random& random, std::size_t most) {
  return std::min(most, std::size_t{1} << below(random, 8)) + below(random, 3);
}

void change(std::string& input, const std::vector<std::string>& corpus, Random& random) {
  const std::size_t at = below(random, input.size() + 1);
  const std::size_t length = std::min(input.size() - at, pieceLength(random, input.size()));
  switch (below(random, 9)) {
    case 0:
      if (at < input.size()) input[at] = static_cast<char>(input[at] ^ (1 << below(random, 8)));
      break;
    case 1:
      if (at < input.size()) input[at] = static_cast<char>(random.bits());
      break;
    case 2:
      input.erase(at, length);
      break;
    case 3:
      input.insert(at, input.substr(at, length));
      break;
    case 4:
      input.insert(at, words[below(random, words.size())]);
      break;
    case 5:
      input.replace(at, length, words[below(random, words.size())]);
      break;
    case 6: {
      const std::string_view pattern = patterns[below(random, patterns.size())];
      input.replace(at, std::min(pattern.size(), input.size() - at), pattern);
      break;
    }
    case 7: {
      const std::string& other = corpus[below(random, corpus.size())];
      const std::size_t from = below(random, other.size() + 1);
      input.replace(at, length, other.substr(from, pieceLength(random, other.size())));
      break;
    }
    default:
      input.resize(at);
      break;
  }
}

}  // namespace

std::string mutated(const std::vector<std::string>& corpus, Random& random) {
  std::string input = corpus[below(random, corpus.size())];
  const std::size_t changes = 1 + below(random, 8);
  for (std::size_t i = 0; i < changes; ++i) change(input, corpus, random);
  return input;
}

}  // namespace scan_to_path::fuzz
