// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace scan_to_path::program {

/// Longest identifier of RobotWare 5 and later (older controllers: 16).
constexpr std::size_t rapid_name_length = 32;

/// True for a name that RAPID takes for data and routines: a letter, then letters, digits and underscores, at most
/// rapid_name_length, not a reserved word or a name that the controller predefines (case does not matter).
bool isRapidName(std::string_view name);

/// Throws InputError, "WHERE: name is '…', must be …", unless isRapidName.
void checkRapidName(const std::string& where, const std::string& name);

/// `prefix`, then `text` with everything but letters, digits and underscores left out, then `suffix`; `text` is cut so
/// that the whole fits. Prefix and suffix make the name unique and legal.
std::string rapidName(const std::string& prefix, std::string_view text, const std::string& suffix = "");

/// `text` with everything but printable ASCII replaced by '?', for comments.
std::string asciiLine(std::string_view text);

}  // namespace scan_to_path::program
