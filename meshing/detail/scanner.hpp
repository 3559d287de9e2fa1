#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

constexpr bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

/// Words and numbers of a text file, with the line for messages. Independent of the locale.
class Scanner {
 public:
  /// `format` begins every message; what follows `comment` on a line is skipped, '\0' for none.
  Scanner(std::string_view format, std::string_view text, char comment)
      : format_(format), rest_(text), comment_(comment) {}

  std::uint32_t line() const { return line_; }
  std::string_view rest() const { return rest_; }

  /// The next word, on whatever line; empty at the end.
  std::string_view word() {
    skip(false);
    return cut_word();
  }
  /// The next word of this line; empty at its end.
  std::string_view word_of_line() {
    skip(true);
    return cut_word();
  }
  /// Skips to the start of the next line; false at the end of the text.
  bool next_line() {
    const std::size_t end = line_end();
    if (end == rest_.size()) {
      rest_ = {};
      return false;
    }
    rest_.remove_prefix(end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1));
    ++line_;
    return true;
  }
  /// Skips the rest of this line, but not its end.
  void skip_line() { rest_.remove_prefix(line_end()); }
  /// The rest of this line, which stays where it is.
  std::string_view rest_of_line() const { return rest_.substr(0, line_end()); }

  /// Makes so many characters, taken last, the next ones again.
  void put_back(std::size_t count) { rest_ = {rest_.data() - count, rest_.size() + count}; }
  /// For binary blocks; lines are not counted in them.
  void skip_bytes(std::size_t count) { rest_.remove_prefix(std::min(count, rest_.size())); }

  /// The same, and counts the lines.
  void skip_counted(std::size_t characters) {
    const std::string_view skipped = rest_.substr(0, characters);
    line_ += static_cast<std::uint32_t>(std::count(skipped.begin(), skipped.end(), '\n'));
    skip_bytes(characters);
  }

  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(std::uint32_t line, const std::string& what) const {
    throw InvalidInput(std::string(format_) + ", line " + std::to_string(line) + ": " + what);
  }

  double number(std::string_view word, std::string_view what) const;
  double number(std::string_view what) { return number(word(), what); }
  /// A count or an index: not negative, at most 2^32 - 2.
  std::uint32_t natural(std::string_view word, std::string_view what) const;
  std::uint32_t natural(std::string_view what) { return natural(word(), what); }
  /// An index of a point counted from `first`, below `count`; returned as counted from 0.
  std::uint32_t index(std::string_view word, std::uint32_t first, std::size_t count) const;
  Point point();

  /// How many entries of at least so many characters the rest can hold: what a count in a header is
  /// compared with before anything is allocated.
  std::size_t room(std::size_t characters) const { return rest_.size() / characters + 1; }
  /// A count that the rest of the text has room for.
  std::uint32_t count(std::string_view what, std::size_t characters) {
    const std::uint32_t value = natural(what);
    if (value > room(characters))
      fail(std::to_string(value) + " announced as " + std::string(what) +
           ", more than the file is long enough for");
    return value;
  }

 private:
  /// Lines end with \n, \r\n or, as on old Macintoshes, \r.
  bool at_line_end() const {
    return rest_.front() == '\n' ||
           (rest_.front() == '\r' && (rest_.size() == 1 || rest_[1] != '\n'));
  }
  std::size_t line_end() const { return std::min(rest_.find_first_of("\r\n"), rest_.size()); }
  void skip(bool within_line) {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (at_line_end()) {
        if (within_line) return;
        ++line_;
        rest_.remove_prefix(1);
      } else if (is_space(c)) {
        rest_.remove_prefix(1);
      } else if (c == comment_ && comment_ != '\0') {
        rest_.remove_prefix(line_end());
      } else {
        return;
      }
    }
  }
  std::string_view cut_word() {
    std::size_t length = 0;
    while (length < rest_.size() && !is_space(rest_[length]) &&
           (comment_ == '\0' || rest_[length] != comment_))
      ++length;
    const std::string_view found = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return found;
  }

  std::string_view format_;
  std::string_view rest_;
  char comment_;
  std::uint32_t line_ = 1;
};

/// The first word of a text with comments from #, if it is near enough to tell a format by.
inline std::string_view first_word(std::string_view text) {
  return Scanner("", text.substr(0, 4096), '#').word();
}

/// To the keyword within what Geomview and its tools write around it: braces, "=", a name, a list
/// of one, how it looks. Returns whether there were braces.
bool skip_oogl_wrapping(Scanner& in);

/// The words of an OBJ line, which goes on behind a "\" at its end.
class ObjLine {
 public:
  explicit ObjLine(Scanner& in) : in_(in) {}

  std::string_view word() {
    std::string_view found = in_.word_of_line();
    while (found == "\\" && in_.next_line()) found = in_.word_of_line();
    if (found.size() > 1 && found.ends_with('\\')) {
      in_.put_back(1);
      found.remove_suffix(1);
    }
    return found;
  }
  /// To its end.
  void skip() {
    while (in_.rest_of_line().ends_with('\\') && in_.next_line()) {
    }
    in_.skip_line();
  }

 private:
  Scanner& in_;
};

}  // namespace tripus::meshing::detail
