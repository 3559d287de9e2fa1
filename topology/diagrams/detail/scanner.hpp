#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "topology/detail/text.hpp"

namespace tripus::topology::detail {

/// Reads a text from the left, and knows where it is.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() {
    skip_space();
    return at_ == text_.size();
  }
  /// The next character that is no white space; '\0' at the end.
  char peek() {
    skip_space();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  char peek_raw() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  bool take_word(std::string_view word) {
    skip_space();
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }
  char take_any() { return text_[at_++]; }
  void expect(char c) {
    if (!take(c)) fail(std::string("expected ") + c + found());
  }
  /// A run of letters; empty if there is none.
  std::string_view letters() {
    skip_space();
    const std::size_t from = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return text_.substr(from, at_ - from);
  }
  bool at_number() {
    const char c = peek();
    return is_digit(c) ||
           ((c == '-' || c == '+') && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]));
  }
  std::int64_t integer() {
    if (!at_number()) fail("expected a whole number" + found());
    const bool plus = text_[at_] == '+';
    at_ += plus;
    const std::size_t from = at_;
    at_ += text_[at_] == '-';
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    const auto value = parse_integer(text_.substr(from, at_ - from));
    if (!value)
      fail("the number " + quoted(std::string(text_.substr(from, at_ - from))) + " is too large");
    return *value;
  }
  /// Everything up to one of these characters, or to the end.
  std::string_view until(std::string_view ends) {
    skip_space();
    const std::size_t from = at_;
    at_ = std::min(text_.find_first_of(ends, at_), text_.size());
    return trimmed(text_.substr(from, at_ - from));
  }

  std::size_t position() const { return at_; }
  void go_to(std::size_t position) { at_ = position; }
  /// "line 2, column 5".
  std::string place(std::size_t at) const {
    std::size_t line = 1, column = 1;
    for (std::size_t i = 0; i < at; ++i)
      if (text_[i] == '\n') {
        ++line;
        column = 1;
      } else {
        ++column;
      }
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
  }
  std::string found() {
    skip_space();
    return at_ == text_.size() ? ", and the text ends"
                               : ", found " + quoted(std::string(text_.substr(at_, 12)));
  }
  [[noreturn]] void fail(const std::string& what) const { fail(what, at_); }
  [[noreturn]] void fail(const std::string& what, std::size_t at) const {
    throw InvalidInput(what + " (" + place(at) + ")");
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

 private:
  /// White space, and comments from # to the end of the line.
  void skip_space() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else
        ++at_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

inline bool is_opening(char c) { return c == '[' || c == '(' || c == '{'; }
inline bool is_closing(char c) { return c == ']' || c == ')' || c == '}'; }
inline char closing_of(char opening) { return opening == '[' ? ']' : opening == '(' ? ')' : '}'; }

}  // namespace tripus::topology::detail
