// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace scan_to_path {

/// What a message shows of a file's text: every byte that is no printable ASCII character as \x1b, and "..." for what
/// is beyond `longest` bytes, so that a message stays one line and does nothing to a terminal.
std::string escaped(std::string_view text, std::size_t longest = 40);

/// The same between single quotes.
std::string inQuotes(std::string_view text);

}  // namespace scan_to_path
