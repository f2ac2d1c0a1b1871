// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace scan_to_path::scan {

/// Plain decimal numbers, several times faster than the general conversions, for logs of a million rows.

/// Parses "[-]digits[.digits]" of up to 15 digits, correctly rounded: such a number is an integer below 2^53 over a
/// power of ten below 10^22, both exact. Returns where it ended; nullptr for anything else (use parseNumber then).
const char* parseDecimal(const char* begin, const char* end, double& value);

/// value * scale rounded to the nearest integer, halves away from zero. Precondition: it fits.
inline std::int64_t roundedTicks(double value, double scale) {
  const double scaled = value * scale;
  return static_cast<std::int64_t>(scaled < 0.0 ? scaled - 0.5 : scaled + 0.5);
}

/// ticks / 10^digits with all its digits, e.g. (-1500, 3) is "-1.500".
void appendTicks(std::string& text, std::int64_t ticks, int digits);

/// `value` with a fixed number of digits (at most 6), "nan" for NaN.
void appendDecimal(std::string& text, double value, int digits);

/// The same without trailing zeros, and without a point when nothing follows it.
void appendShortest(std::string& text, double value, int digits);

}  // namespace scan_to_path::scan
