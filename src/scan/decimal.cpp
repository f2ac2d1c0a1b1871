// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "decimal.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "scan_to_path/common/text.h"

namespace scan_to_path::scan {
namespace {

constexpr std::array<double, 16> powers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                           1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// Appends the digits at the end of `buffer`; returns where they begin.
std::size_t writeTicks(std::array<char, 24>& buffer, std::int64_t ticks, int digits) {
  std::uint64_t rest = ticks < 0 ? 0 - static_cast<std::uint64_t>(ticks) : static_cast<std::uint64_t>(ticks);
  std::size_t at = buffer.size();
  for (int k = 0; k < digits; ++k) {
    buffer[--at] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  }
  if (digits > 0) buffer[--at] = '.';
  do {
    buffer[--at] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest != 0);
  if (ticks < 0) buffer[--at] = '-';
  return at;
}

bool fitsTicks(double value, int digits) { return std::abs(value) * powers[static_cast<std::size_t>(digits)] < 9e18; }

}  // namespace

const char* parseDecimal(const char* begin, const char* end, double& value) {
  const char* at = begin;
  const bool negative = at != end && *at == '-';
  if (negative) ++at;
  std::uint64_t mantissa = 0;
  const char* const digits = at;
  while (at != end && *at >= '0' && *at <= '9') mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at++ - '0');
  std::ptrdiff_t count = at - digits;
  std::size_t decimals = 0;
  if (at != end && *at == '.') {
    const char* const fraction = ++at;
    while (at != end && *at >= '0' && *at <= '9') mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at++ - '0');
    decimals = static_cast<std::size_t>(at - fraction);
    count += at - fraction;
  }
  if (count == 0 || count > 15) return nullptr;
  const double magnitude = static_cast<double>(mantissa) / powers[decimals];
  value = negative ? -magnitude : magnitude;
  return at;
}

void appendTicks(std::string& text, std::int64_t ticks, int digits) {
  std::array<char, 24> buffer;
  const std::size_t at = writeTicks(buffer, ticks, digits);
  text.append(buffer.data() + at, buffer.size() - at);
}

void appendDecimal(std::string& text, double value, int digits) {
  if (std::isnan(value)) {
    text += "nan";
  } else if (fitsTicks(value, digits)) {
    appendTicks(text, roundedTicks(value, powers[static_cast<std::size_t>(digits)]), digits);
  } else {
    appendFixed(text, value, digits);
  }
}

void appendShortest(std::string& text, double value, int digits) {
  const std::size_t begin = text.size();
  appendDecimal(text, value, digits);
  if (text.find('.', begin) == std::string::npos) return;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
}

}  // namespace scan_to_path::scan
