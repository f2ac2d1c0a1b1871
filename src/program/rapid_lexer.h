// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace scan_to_path::program {

enum class TokenKind { name, number, string, symbol, end };

/// A word of a RAPID module.
struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;     ///< names in lower case (RAPID does not tell cases apart); symbols as they stand
  double number = 0.0;  ///< of a number
  int line = 0;
};

/// Cuts a module into words; comments and the %%% header are left out. The last token is `end`.
/// Throws InputError, "FILE line N: …", for characters and numbers that RAPID does not have.
std::vector<Token> rapidTokens(const std::string& text, const std::string& file);

}  // namespace scan_to_path::program
