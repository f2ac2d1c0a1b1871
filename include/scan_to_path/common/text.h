// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scan_to_path {

/// The whole file. Throws InputError when it cannot be read.
std::string readFile(const std::filesystem::path& path);

/// Appends `value` with a fixed number of digits after the point; "-0.00" is written "0.00".
/// Locale-independent, the same bytes everywhere.
void appendFixed(std::string& text, double value, int digits);
void appendInteger(std::string& text, std::int64_t value);
std::string fixed(double value, int digits);

/// The number that all of `text` is, by std::from_chars (no locale); false when it is not one.
/// Accepts "nan" and "inf": callers check finiteness and say so by name.
bool parseNumber(std::string_view text, double& value);

std::string_view trimmed(std::string_view text);
std::vector<std::string_view> split(std::string_view text, char separator);

/// The candidate closest to `word` by edit distance, for "unknown X, did you mean Y"; empty without candidates.
std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates);

/// Lower-case hexadecimal SHA-256 of `bytes`.
std::string sha256(std::string_view bytes);

}  // namespace scan_to_path
