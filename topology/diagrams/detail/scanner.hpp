#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "topology/detail/text.hpp"

namespace tripus::topology::detail {

/// Reads a text from the left, and knows where it is.
class DiagramScanner {
 public:
  explicit DiagramScanner(std::string_view text) : text_(text) {}

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
  /// The same in capitals or small letters, and only as a whole word.
  bool take_whole_word(std::string_view word) {
    skip_space();
    const std::size_t from = at_;
    if (same_word(letters(), word)) return true;
    at_ = from;
    return false;
  }
  char take_any() { return text_[at_++]; }
  void expect(char c) {
    if (!take(c)) fail(std::string("expected ") + c + found());
  }
  /// What was read since a position.
  std::string_view since(std::size_t from) const { return text_.substr(from, at_ - from); }
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
  /// What comes next, in quotes.
  std::string ahead() const { return quoted(std::string(text_.substr(at_, 12))); }
  std::string found() { return at_end() ? ", and the text ends" : ", found " + ahead(); }
  [[noreturn]] void fail(const std::string& what) const { fail(what, at_); }
  [[noreturn]] void fail(const std::string& what, std::size_t at) const {
    throw InvalidInput(what + " (" + place(at) + ")");
  }

  /// Whether two words differ in capitals at most.
  static bool same_word(std::string_view one, std::string_view two) {
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
    return std::ranges::equal(one, two, {}, small, small);
  }
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

/// The brackets that are open around what is read. They must match and close.
class Brackets {
 public:
  std::size_t depth() const { return open_.size(); }
  /// Takes an opening bracket.
  void open(DiagramScanner& scan) {
    const char c = scan.peek();
    open_.emplace_back(c, scan.position());
    scan.take_any();
  }
  /// Takes a closing one.
  void close(DiagramScanner& scan) {
    const char c = scan.peek();
    if (open_.empty())
      scan.fail(std::string("the bracket ") + c + " closes nothing that is open; take it away");
    const auto [opening, at] = open_.back();
    if (closing_of(opening) != c)
      scan.fail(named(scan) + " is closed by " + c + "; write " + closing_of(opening));
    open_.pop_back();
    scan.take_any();
  }
  /// Refuses what stands where the innermost bracket ought to close.
  [[noreturn]] void fail_open(DiagramScanner& scan) const {
    const bool ends = scan.at_end();
    scan.fail(named(scan) + " is not closed; add " + closing_of(open_.back().first) +
              (ends ? " at the end" : " before " + scan.ahead()));
  }
  /// At the end.
  void require_closed(DiagramScanner& scan) const {
    if (!open_.empty()) fail_open(scan);
  }

 private:
  std::string named(const DiagramScanner& scan) const {
    return std::string("the bracket ") + open_.back().first + " of " +
           scan.place(open_.back().second);
  }

  std::vector<std::pair<char, std::size_t>> open_;
};

/// Whether a text begins with a word, in capitals or small letters, and a sign that no word has: a
/// colon, a bracket, white space and the like.
inline bool has_heading(std::string_view text, std::string_view word) {
  return text.size() > word.size() &&
         DiagramScanner::same_word(text.substr(0, word.size()), word) &&
         (is_space(text[word.size()]) ||
          std::string_view(":=[({").find(text[word.size()]) != std::string_view::npos);
}

}  // namespace tripus::topology::detail
