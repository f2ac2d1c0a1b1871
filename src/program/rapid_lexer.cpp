// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rapid_lexer.h"

#include <charconv>
#include <cmath>

#include "scan_to_path/common/error.h"

namespace scan_to_path::program {
namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }
bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class Lexer {
public:
  Lexer(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  std::vector<Token> run() {
    skipFileHeader();
    for (skipBlanks(); at_ < text_.size(); skipBlanks()) tokens_.push_back(next());
    tokens_.push_back({TokenKind::end, "", 0.0, line_});
    return std::move(tokens_);
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + " line " + std::to_string(line_) + ": " + what);
  }

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  /// Older controllers begin a file with %%% VERSION:… %%%.
  void skipFileHeader() {
    skipBlanks();
    if (text_.compare(at_, 3, "%%%") != 0) return;
    const std::size_t end = text_.find("%%%", at_ + 3);
    if (end == std::string::npos) fail("the %%% header has no end");
    for (; at_ < end + 3; ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
  }

  void skipBlanks() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '!') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
        if (at_ == text_.size()) return;
      } else if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
        return;
      }
      if (text_[at_] == '\n') ++line_;
    }
  }

  Token next() {
    const char c = peek();
    if (letter(c)) return name();
    if (digit(c) || (c == '.' && digit(peek(1)))) return number();
    if (c == '"') return quoted();
    return symbol();
  }

  Token name() {
    Token token{TokenKind::name, "", 0.0, line_};
    while (letter(peek()) || digit(peek()) || peek() == '_') {
      const char c = text_[at_++];
      token.text += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    }
    return token;
  }

  Token number() {
    const std::size_t begin = at_;
    while (digit(peek())) ++at_;
    if (peek() == '.') ++at_;
    while (digit(peek())) ++at_;
    if (peek() == 'e' || peek() == 'E') {
      const std::size_t digits = at_ + (peek(1) == '+' || peek(1) == '-' ? 2 : 1);
      if (digits >= text_.size() || !digit(text_[digits])) fail("number without exponent");
      at_ = digits;
      while (digit(peek())) ++at_;
    }
    Token token{TokenKind::number, text_.substr(begin, at_ - begin), 0.0, line_};
    const auto result = std::from_chars(text_.data() + begin, text_.data() + at_, token.number);
    if (result.ec != std::errc() || !std::isfinite(token.number)) fail("number " + token.text + " is out of range");
    return token;
  }

  Token quoted() {
    Token token{TokenKind::string, "", 0.0, line_};
    for (++at_; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == '"') {
        if (peek(1) != '"') {
          ++at_;
          return token;
        }
        ++at_;
      }
      token.text += text_[at_];
    }
    fail("string has no end");
  }

  Token symbol() {
    for (const char* pair : {":=", "<=", ">=", "<>"}) {
      if (text_.compare(at_, 2, pair) == 0) {
        at_ += 2;
        return {TokenKind::symbol, pair, 0.0, line_};
      }
    }
    const char c = peek();
    if (std::string("[](),;\\:=<>+-*/{}.?").find(c) == std::string::npos) {
      fail("character " + std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + " has no meaning in RAPID");
    }
    ++at_;
    return {TokenKind::symbol, std::string(1, c), 0.0, line_};
  }

  const std::string& text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> rapidTokens(const std::string& text, const std::string& file) { return Lexer(text, file).run(); }

}  // namespace scan_to_path::program
