#include "meshing/detail/scanner.hpp"

#include <algorithm>
#include <string_view>

namespace tripus::meshing::detail {
namespace {

std::string shown(std::string_view word) {
  return word.empty() ? "nothing" : quoted(std::string(word.substr(0, 64)));
}

}  // namespace

double Scanner::number(std::string_view word, std::string_view what) const {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range)
    fail(shown(word) + " is too large or too small for a double; scale the mesh");
  if (error != std::errc() || end != digits.data() + digits.size() || digits.starts_with('+') ||
      (word.size() != digits.size() && digits.starts_with('-')))
    fail(shown(word) + " where " + std::string(what) + " was expected");
  return value;
}

std::uint32_t Scanner::natural(std::string_view word, std::string_view what) const {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value == UINT32_MAX)
    fail(shown(word) + " where " + std::string(what) + " was expected");
  return value;
}

std::uint32_t Scanner::index(std::string_view word, std::uint32_t first, std::size_t count) const {
  const std::uint32_t value = natural(word, "the number of a point");
  if (value < first || value - first >= count)
    fail("point " + std::to_string(value) + " does not exist; the file has " +
         std::to_string(count) + " points, numbered from " + std::to_string(first));
  return value - first;
}

Point Scanner::point() {
  Point p;
  for (double& x : p) x = number("a coordinate");
  return p;
}

namespace {

/// A word of OOGL, in which braces are words of their own.
std::string_view oogl_word(Scanner& in) {
  const std::string_view word = in.word();
  const std::size_t brace = word.find_first_of("{}");
  if (brace == std::string_view::npos || word.size() == 1) return word;
  const std::size_t length = std::max<std::size_t>(brace, 1);
  in.put_back(word.size() - length);
  return word.substr(0, length);
}

/// Past the block in braces that comes next.
void skip_block(Scanner& in) {
  int depth = 0;
  do {
    const std::string_view word = oogl_word(in);
    if (word.empty()) return;
    if (word == "{") ++depth;
    if (word == "}") --depth;
  } while (depth > 0);
}

}  // namespace

bool skip_oogl_wrapping(Scanner& in) {
  bool in_braces = false;
  for (Scanner ahead = in;; in = ahead) {
    const std::string_view word = oogl_word(ahead);
    if (word == "{") {
      in_braces = true;
    } else if (word == "appearance") {
      skip_block(ahead);
    } else if (word == "define") {
      ahead.word();
    } else if (word != "=" && word != "LIST") {
      return in_braces;
    }
  }
}

}  // namespace tripus::meshing::detail
