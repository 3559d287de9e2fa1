#include "meshing/detail/oogl.hpp"

#include <algorithm>
#include <string_view>

namespace tripus::meshing::detail {
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
