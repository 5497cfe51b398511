// SPDX-License-Identifier: Apache-2.0
#include "case/toml_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace pulvis::case_file {
namespace {

// Limits far above any real case; each bounds a recursion or a cost of the library behind.
constexpr std::size_t largest_text = 4u << 20;   // bytes
constexpr std::size_t longest_line = 64u << 10;  // bytes
constexpr std::size_t deepest_bracket = 32;      // nested lists and inline tables
constexpr int longest_dotted_key = 16;           // parts

// The length of the UTF-8 character at the start of `text`, 0 if there is none. Refuses overlong
// forms, surrogates and values above U+10FFFF (RFC 3629).
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const unsigned second = byte(1);
  if (first == 0xE0 && second < 0xA0) return 0;
  if (first == 0xED && second > 0x9F) return 0;
  if (first == 0xF0 && second < 0x90) return 0;
  if (first == 0xF4 && second > 0x8F) return 0;
  return length;
}

// Walks a text character by character and knows what it is in. It is no TOML reader: it understands
// strings, comments and brackets, and stops at the first thing that the reader must not see.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  std::optional<SyntaxError> run(int stop_line, int stop_column) {
    while (at_ < text_.size() && !error_ &&
           !(line_ > stop_line || (line_ == stop_line && column_ >= stop_column)))
      step();
    if (!error_ && at_ >= text_.size()) check_end();
    return error_;
  }

  std::optional<Place> innermost() const {
    return brackets_.empty() ? std::nullopt : std::optional(brackets_.back());
  }

 private:
  enum class Inside { nothing, comment, basic, literal, long_basic, long_literal };

  Place here(int length = 1) const { return {0, line_, column_, length}; }
  void refuse(const Place& place, std::string message, std::string expected = "") {
    error_ = SyntaxError{place, std::move(message), std::move(expected)};
  }
  bool follows(std::string_view what) const { return text_.substr(at_).starts_with(what); }
  void advance(std::size_t characters) { at_ += characters, column_ += static_cast<int>(characters); }

  void step() {
    const char c = text_[at_];
    const std::size_t length = character_length(text_.substr(at_));
    if (length == 0) return refuse(here(), "a byte that is not UTF-8", "the file must be saved as UTF-8");
    const bool line_end = c == '\n' || follows("\r\n");
    const auto code = static_cast<unsigned char>(c);
    if (!line_end && ((code < 0x20 && c != '\t') || code == 0x7F))
      return refuse(here(), fmt::format("a control character (code {})", static_cast<int>(code)));
    if (length > 1 && inside_ == Inside::nothing)
      return refuse(here(), fmt::format("\"{}\" outside a string or comment", text_.substr(at_, length)),
                    "keys are written in the letters a to z, or in quotes");
    if (c == '\n') return end_line();
    if (length > 1) return at_ += length, ++column_, void();
    switch (inside_) {
      case Inside::nothing:
        return outside(c);
      case Inside::comment:
        return advance(1);
      case Inside::basic:
      case Inside::long_basic:
        if (c == '\\') return escaped();
        [[fallthrough]];
      default:
        return in_string(c);
    }
  }

  void end_line() {
    if (inside_ == Inside::basic || inside_ == Inside::literal)
      return refuse(opened_, "this string is not closed", "a closing quote on the same line");
    if (inside_ == Inside::comment) inside_ = Inside::nothing;
    ++at_, ++line_, column_ = 1, dots_ = 0;
  }

  // The character after a backslash cannot end the string; the end of the line is left to `step`.
  void escaped() {
    advance(1);
    if (at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\\')) advance(1);
  }

  void outside(char c) {
    if (c == '#') inside_ = Inside::comment;
    if (c == '"' || c == '\'') return open_string(c);
    if (c == '.' && ++dots_ >= longest_dotted_key) return refuse(here(), "a key of too many parts");
    if (c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') dots_ = 0;
    if (c == '[' || c == '{') {
      brackets_.push_back(here());
      if (brackets_.size() > deepest_bracket) return refuse(here(), "brackets nested too deep");
    }
    // One that closes nothing, or the wrong kind, is the reader's to report.
    if ((c == ']' || c == '}') && !brackets_.empty()) brackets_.pop_back();
    advance(1);
  }

  void open_string(char quote) {
    opened_ = here();
    const bool is_long = follows(quote == '"' ? "\"\"\"" : "'''");
    if (quote == '"')
      inside_ = is_long ? Inside::long_basic : Inside::basic;
    else
      inside_ = is_long ? Inside::long_literal : Inside::literal;
    advance(is_long ? 3 : 1);
  }

  void in_string(char c) {
    const bool is_long = inside_ == Inside::long_basic || inside_ == Inside::long_literal;
    const bool basic = inside_ == Inside::basic || inside_ == Inside::long_basic;
    if (c != (basic ? '"' : '\'')) return advance(1);
    if (!is_long) return inside_ = Inside::nothing, advance(1);
    if (!follows(basic ? "\"\"\"" : "'''")) return advance(1);
    advance(3);
    // TOML lets up to two more quotes belong to the content before the closing three.
    for (int extra = 0; extra < 2 && at_ < text_.size() && text_[at_] == c; ++extra) advance(1);
    inside_ = Inside::nothing;
  }

  void check_end() {
    if (inside_ == Inside::basic || inside_ == Inside::literal || inside_ == Inside::long_basic ||
        inside_ == Inside::long_literal)
      refuse(opened_, "this string is not closed", "its closing quotes before the end of the file");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  int dots_ = 0;
  Inside inside_ = Inside::nothing;
  Place opened_;
  std::vector<Place> brackets_;
  std::optional<SyntaxError> error_;
};

std::optional<SyntaxError> refuse_size(std::string_view text) {
  if (text.size() > largest_text)
    return SyntaxError{{}, fmt::format("the file has {} bytes", text.size()), "at most 4 MiB"};
  int line = 1;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end - at > longest_line)
      return SyntaxError{{0, line, 1, 1}, fmt::format("a line of {} bytes", end - at), "at most 64 KiB"};
    at = end + 1;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SyntaxError> refuse_text(std::string_view text) {
  if (auto error = refuse_size(text)) return error;
  constexpr int never = 1 << 30;
  return Scanner(text).run(never, never);
}

std::optional<Place> open_bracket_at(std::string_view text, int line, int column) {
  Scanner scanner(text);
  if (scanner.run(line, column)) return std::nullopt;
  return scanner.innermost();
}

}  // namespace pulvis::case_file
